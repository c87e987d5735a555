#include "arrangement/Arranged.hpp"

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "arrangement/complex/Curves.hpp"
#include "arrangement/complex/EdgeCollapse.hpp"
#include "arrangement/exact/ExactArrangement.hpp"
#include "arrangement/exact/Rounding.hpp"
#include "arrangement/preparation/Snap.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

namespace asperity::geometry
{
namespace
{
constexpr double weld_share = 1e-6; // of the diagonal of the box

Point<3> middleOf(Complex const& complex, Edge const& edge)
{
  Point<3> middle;
  for (int d = 0; d < 3; ++d) {
    middle[d] = 0.5 * (complex.points[edge[0]][d] + complex.points[edge[1]][d]);
  }
  return middle;
}
} // namespace

Arranged arrangeModel(Model model, ArrangementOptions const& options, SizeFromFaults const& sizes)
{
  Arranged result;
  const auto is_moved = pushBorders(model, options.snap);
  for (auto const& of_surface : is_moved) {
    result.num_pushed += static_cast<int>(std::count(of_surface.begin(), of_surface.end(), true));
  }
  auto arrangement = arrange(model.surfaces);
  result.dropped = keepBody(arrangement, model, is_moved, options.stub_share);
  result.complex = std::move(arrangement.complex);
  removeRounding(result.complex, weld_share * mesh::distance<3>(model.box.low, model.box.high));
  if (options.short_share > 0) {
    const auto size = sizes(result.complex);
    result.num_contracted = contractShortEdges(result.complex, model, [&](Point<3> const& place) {
      return options.short_share * size(place);
    });
  }
  return result;
}

std::vector<Junction> junctions(Complex const& complex, Model const& model)
{
  std::map<std::pair<int, int>, Junction> found;
  for (auto const& curve : findCurves(complex)) {
    std::map<int, int> sheets; // of each fault
    for (int s : curve.surfaces) {
      if (model.isFault(s)) {
        ++sheets[s];
      }
    }
    for (auto first = sheets.begin(); first != sheets.end(); ++first) {
      for (auto second = std::next(first); second != sheets.end(); ++second) {
        const bool is_crossing = first->second > 1 && second->second > 1;
        auto const& ending = second->second > first->second ? first : second;
        auto const& going_on = ending == first ? second : first;
        auto& junction = found[{going_on->first, ending->first}];
        junction.first = model.name(going_on->first);
        junction.second = model.name(ending->first);
        if (is_crossing || junction.length == 0) {
          junction.from = complex.points[curve.points.front()];
          junction.to = complex.points[curve.points.back()];
        }
        junction.is_crossing = junction.is_crossing || is_crossing;
        junction.length += lengthOf(complex, curve);
      }
    }
  }
  std::vector<Junction> list;
  for (auto const& [pair, junction] : found) {
    list.push_back(junction);
  }
  return list;
}

AngleAt smallestAngle(Complex const& complex, Model const& model)
{
  AngleAt smallest;
  for (auto const& [edge, triangles] : trianglesAtEdges(complex.triangles)) {
    if (triangles.size() == 2 && complex.surfaces[triangles[0]] == complex.surfaces[triangles[1]]) {
      continue;
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto u = inward(complex.points, edge, complex.triangles[triangles[i]]);
        const auto v = inward(complex.points, edge, complex.triangles[triangles[j]]);
        const double degrees =
          std::acos(std::clamp(mesh::dot<3>(u, v), -1., 1.)) * 180 / std::acos(-1.);
        if (degrees < smallest.degrees) {
          smallest = {degrees, middleOf(complex, edge), model.name(complex.surfaces[triangles[j]]),
                      model.name(complex.surfaces[triangles[i]])};
        }
      }
    }
  }
  return smallest;
}

LengthAt shortestCurve(Complex const& complex)
{
  LengthAt shortest{std::numeric_limits<double>::infinity(), {}};
  for (auto const& curve : findCurves(complex)) {
    const double length = lengthOf(complex, curve);
    if (length < shortest.length) {
      shortest = {length, complex.points[curve.points.front()]};
    }
  }
  return shortest;
}
} // namespace asperity::geometry
