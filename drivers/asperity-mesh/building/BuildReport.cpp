#include "building/BuildReport.hpp"

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "arrangement/complex/TriangleTree.hpp"
#include "meshing/CellAngles.hpp"
#include "surfaces/TriangleSurface.hpp"

#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <set>

namespace asperity::geometry
{
namespace
{
const double degrees_per_radian = 180 / std::acos(-1.);

std::string areaText(double area) { return formatShort(area / 1e6) + " km^2"; }

std::vector<Point<3>> pointsOf(std::vector<Point<3>> const& all,
                               std::vector<Triangle> const& triangles)
{
  std::set<int> numbers;
  for (auto const& t : triangles) {
    numbers.insert(t.begin(), t.end());
  }
  std::vector<Point<3>> points;
  for (int v : numbers) {
    points.push_back(all[v]);
  }
  return points;
}

std::string shapeText(FaultShape const& shape)
{
  return areaText(shape.area) + ", strike " + formatted("%.0f", shape.strike) + ", dip " +
         formatted("%.0f", shape.dip) + " degrees";
}

void reportDropped(Arranged const& arranged, std::ostream& out)
{
  struct Sum
  {
    int number = 0;
    double area = 0, largest = 0;
    Point<3> place{};
  };
  constexpr char const* reasons[] = {"outside the box or above the ground",
                                     "across another surface after a border was moved there",
                                     "with a free end behind another surface (stubs)"};
  std::map<std::pair<std::string, int>, Sum> sums;
  for (auto const& piece : arranged.dropped) {
    if (!piece.is_fault) {
      continue; // ground and walls extend beyond the body by construction
    }
    auto& sum = sums[{piece.surface, static_cast<int>(piece.reason)}];
    ++sum.number;
    sum.area += piece.area;
    if (piece.area > sum.largest) {
      sum.largest = piece.area;
      sum.place = piece.place;
    }
  }
  for (auto const& [key, sum] : sums) {
    out << "left out of '" << key.first << "': " << sum.number
        << (sum.number == 1 ? " piece " : " pieces ") << reasons[key.second] << ", "
        << areaText(sum.area) << ", the largest at " << placeText(sum.place) << '\n';
  }
}
} // namespace

FaultShape shapeOf(std::vector<Point<3>> const& points, std::vector<Triangle> const& triangles)
{
  FaultShape shape;
  Point<3> sum{};
  for (auto const& triangle : triangles) {
    shape.area += areaOf(points, triangle);
    const auto normal = normalOf(points, triangle);
    for (int d = 0; d < 3; ++d) {
      sum[d] += normal[d];
    }
  }
  const double length = std::sqrt(mesh::dot<3>(sum, sum));
  if (length > 0) {
    if (sum[2] < 0) {
      sum = {-sum[0], -sum[1], -sum[2]};
    }
    shape.dip = std::acos(std::clamp(sum[2] / length, -1., 1.)) * degrees_per_radian;
    // The normal that points up leans towards the direction of dip.
    shape.strike = std::atan2(sum[0], sum[1]) * degrees_per_radian - 90;
    shape.strike += shape.strike < 0 ? 360 : 0;
  }
  return shape;
}

DistanceAt largestDistance(std::vector<Point<3>> const& points, std::vector<Triangle> const& facets,
                           TriangleSurface const& surface)
{
  const TriangleTree tree(surface.points, surface.triangles);
  DistanceAt largest;
  for (auto const& facet : facets) {
    const auto centre = centroidOf(points, facet);
    const double distance = tree.nearest(centre).distance;
    if (distance > largest.distance) {
      largest = {distance, centre};
    }
  }
  return largest;
}

std::vector<CellAngle> smallestAngles(GlobalMesh<3> const& mesh, std::size_t number)
{
  std::vector<CellAngle> angles;
  for (auto const& cell : mesh.cells) {
    const auto x = mesh::corners<3>(mesh.vertices, cell);
    auto& angle = angles.emplace_back();
    angle.degrees = smallestDihedral(x);
    for (auto const& corner : x) {
      for (int d = 0; d < 3; ++d) {
        angle.place[d] += corner[d] / 4;
      }
    }
  }
  number = std::min(number, angles.size());
  std::partial_sort(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(number),
                    angles.end(),
                    [](auto const& a, auto const& b) { return a.degrees < b.degrees; });
  angles.resize(number);
  return angles;
}

EdgeLengths edgeLengths(GlobalMesh<3> const& mesh, double bound)
{
  std::vector<std::array<int, 2>> edges;
  edges.reserve(6 * mesh.cells.size());
  for (auto const& cell : mesh.cells) {
    for (std::size_t i = 0; i < cell.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        edges.push_back({std::min(cell[i], cell[j]), std::max(cell[i], cell[j])});
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  EdgeLengths result;
  result.number = edges.size();
  result.shortest.length = std::numeric_limits<double>::infinity();
  for (auto const& [first, second] : edges) {
    auto const &a = mesh.vertices[first], &b = mesh.vertices[second];
    const EdgeLengths::Edge edge = {mesh::distance<3>(a, b),
                                    {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}};
    result.num_longer += edge.length > bound ? 1 : 0;
    result.shortest = edge.length < result.shortest.length ? edge : result.shortest;
    result.longest = edge.length > result.longest.length ? edge : result.longest;
  }
  return result;
}

void report(Arranged const& arranged, Model const& model, std::ostream& out)
{
  std::vector<std::vector<Triangle>> of_surface(model.surfaces.size());
  for (std::size_t i = 0; i < arranged.complex.triangles.size(); ++i) {
    of_surface[arranged.complex.surfaces[i]].push_back(arranged.complex.triangles[i]);
  }
  for (int s = 0; s < model.num_faults; ++s) {
    out << "fault '" << model.name(s)
        << "': " << shapeText(shapeOf(arranged.complex.points, of_surface[s])) << ", given "
        << areaText(areaOf(model.surfaces[s].surface)) << "; "
        << extentText(pointsOf(arranged.complex.points, of_surface[s])) << '\n';
  }
  reportDropped(arranged, out);
  if (arranged.num_pushed > 0) {
    out << "borders moved to meet another surface: " << arranged.num_pushed << " points (Snap)\n";
  }
  if (arranged.num_contracted > 0) {
    out << "short curves contracted: " << arranged.num_contracted << " (Shortest Edge)\n";
  }
  for (auto const& junction : junctions(arranged.complex, model)) {
    out << "faults '" << junction.first << "' and '" << junction.second << "' "
        << (junction.is_crossing ? "cross" : "meet") << " along "
        << formatShort(junction.length / 1000) << " km, from " << placeText(junction.from) << " to "
        << placeText(junction.to) << '\n';
  }
  const auto angle = smallestAngle(arranged.complex, model);
  out << "smallest angle between surfaces: " << formatted("%.1f", angle.degrees) << " degrees, of '"
      << angle.first << "' and '" << angle.second << "' at " << placeText(angle.place) << '\n';
  const auto curve = shortestCurve(arranged.complex);
  out << "shortest curve: " << formatShort(curve.length) << " m at " << placeText(curve.place)
      << std::endl;
}

std::string about(double value)
{
  const double unit = std::pow(10, std::floor(std::log10(std::max(value, 1e-12))) - 1);
  return formatShort(std::round(value / unit) * unit);
}

void report(CellEstimate const& expected, std::ostream& out)
{
  out << "expected: about " << about(expected.cells) << " cells, " << about(expected.vertices)
      << " vertices, accurate to a factor of " << estimate_factor << std::endl;
}

void report(GlobalMesh<3> const& mesh, Model const& model, double largest, std::ostream& out)
{
  for (int s = 0; s < model.num_faults; ++s) {
    auto const& facets = mesh.boundaries.at(model.name(s));
    const auto off = largestDistance(mesh.vertices, facets, model.surfaces[s].surface);
    out << "fault '" << model.name(s) << "': " << facets.size() << " facets, "
        << shapeText(shapeOf(mesh.vertices, facets)) << ", centres at most "
        << formatShort(off.distance) << " m from what was given, at " << placeText(off.place)
        << '\n';
  }
  constexpr std::size_t shown = 3;
  out << "smallest dihedral angles of cells:";
  for (auto const& angle : smallestAngles(mesh, shown)) {
    out << ' ' << formatted("%.1f", angle.degrees) << " degrees at " << placeText(angle.place)
        << ';';
  }
  out << '\n';
  const auto edges = edgeLengths(mesh, largest);
  out << "shortest edge: " << formatShort(edges.shortest.length) << " m at "
      << placeText(edges.shortest.place) << "\nlongest edge: " << formatShort(edges.longest.length)
      << " m at " << placeText(edges.longest.place) << '\n';
  if (edges.num_longer > 0) {
    out << edges.num_longer << " of " << edges.number
        << " edges are longer than Largest = " << formatShort(largest) << " m, by up to "
        << formatted("%.0f", 100 * (edges.longest.length / largest - 1)) << " %\n";
  }
}
} // namespace asperity::geometry
