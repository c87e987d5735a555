#include "meshing/DiscreteModel.hpp"

#include "arrangement/complex/Complex.hpp"
#include "gmsh/GmshSession.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <gmsh.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace asperity::geometry
{
namespace
{
namespace model = gmsh::model;

std::size_t tagOf(int point) { return static_cast<std::size_t>(point) + 1; }
} // namespace

DiscreteModel::DiscreteModel(Complex const& complex, Model const& named_model)
    : complex_(complex)
    , model_(named_model)
    , curves_(findCurves(complex))
    , patches_(findPatches(complex))
    , triangles_of_(patches_.list.size())
    , has_node_(complex.points.size(), false)
{
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    triangles_of_[patches_.patch_of_triangle[i]].push_back(static_cast<int>(i));
  }
}

void DiscreteModel::build()
{
  addCorners();
  addCurves();
  for (std::size_t p = 0; p < triangles_of_.size(); ++p) {
    addPatch(static_cast<int>(p));
  }
  addElements();
  model::mesh::createGeometry();
  addVolume();
  embed();
}

// The width 1.5 area / perimeter of patches and of the curves around them.
std::map<std::pair<int, int>, double> DiscreteModel::widths() const
{
  std::map<std::pair<int, int>, double> widths;
  for (std::size_t p = 0; p < triangles_of_.size(); ++p) {
    double perimeter = 0;
    for (int c : borders_[p]) {
      perimeter += lengthOf(complex_, curves_[c - 1]);
    }
    const double width = 1.5 * patches_.list[p].area / perimeter;
    widths[{2, static_cast<int>(p) + 1}] = width;
    for (int c : borders_[p]) {
      auto& of_curve = widths.emplace(std::pair(1, c), width).first->second;
      of_curve = std::min(of_curve, width);
    }
  }
  return widths;
}

std::map<std::string, std::vector<int>> DiscreteModel::surfacesByName() const
{
  std::map<std::string, std::vector<int>> surfaces;
  for (std::size_t p = 0; p < patches_.list.size(); ++p) {
    surfaces[model_.name(patches_.list[p].surface)].push_back(static_cast<int>(p) + 1);
  }
  return surfaces;
}

void DiscreteModel::addNodes(int dimension, int entity, std::vector<int> const& points)
{
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  for (int v : points) {
    tags.push_back(tagOf(v));
    coordinates.insert(coordinates.end(), complex_.points[v].begin(), complex_.points[v].end());
    has_node_[v] = true;
  }
  model::mesh::addNodes(dimension, entity, tags, coordinates);
}

void DiscreteModel::addCorners()
{
  std::set<int> corners;
  for (auto const& curve : curves_) {
    corners.insert({curve.points.front(), curve.points.back()});
  }
  for (int v : corners) {
    const int tag = static_cast<int>(corner_.size()) + 1;
    corner_[v] = tag;
    model::addDiscreteEntity(0, tag);
    addNodes(0, tag, {v});
    model::mesh::addElementsByType(tag, type_point, {}, {tagOf(v)});
  }
}

void DiscreteModel::addCurves()
{
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    const int tag = static_cast<int>(c) + 1;
    auto const& points = curves_[c].points;
    model::addDiscreteEntity(1, tag, {corner_.at(points.front()), corner_.at(points.back())});
    addNodes(1, tag, {points.begin() + 1, points.end() - 1});
    for (std::size_t i = 1; i < points.size(); ++i) {
      curve_at_[edgeOf(points[i - 1], points[i])] = tag;
    }
  }
}

// Curves at which the patch lies on one side bound it; those inside it are embedded.
void DiscreteModel::addPatch(int p)
{
  std::map<int, int> sides; // of the patch at an edge of the curve
  std::set<int> points, on_curves;
  std::set<Edge> edges;
  std::map<Edge, int> count;
  for (int i : triangles_of_[p]) {
    auto const& t = complex_.triangles[i];
    points.insert(t.begin(), t.end());
    for (int k = 0; k < 3; ++k) {
      const auto edge = edgeOf(t, k);
      edges.insert(edge);
      if (curve_at_.count(edge) > 0) {
        ++count[edge];
        on_curves.insert(edge.begin(), edge.end());
      }
    }
  }
  for (auto const& [edge, number] : count) {
    sides[curve_at_.at(edge)] = number;
  }
  auto& borders = borders_.emplace_back();
  auto& inner = inner_.emplace_back();
  for (auto const& [curve, number] : sides) {
    (number == 1 ? borders : inner).push_back(curve);
  }
  auto const& name = model_.name(patches_.list[p].surface);
  const auto place =
    placeText(centroidOf(complex_.points, complex_.triangles[patches_.list[p].largest]));
  ASPERITY_REQUIRE(!borders.empty(),
                   "'" << name << "' is closed at " << place
                       << ", as a sphere is. Cut it into two surfaces with a name each.");
  requireNoHandle(static_cast<int>(points.size()), static_cast<int>(edges.size()), p, name, place);
  const int tag = p + 1;
  model::addDiscreteEntity(2, tag, borders);
  std::vector<int> own;
  auto& touched = touched_.emplace_back();
  for (int v : points) {
    if (!has_node_[v]) {
      own.push_back(v);
    } else if (on_curves.count(v) == 0 && corner_.count(v) > 0) {
      touched.push_back(corner_.at(v));
    }
  }
  addNodes(2, tag, own);
}

// Euler's number of a sphere with h holes is 2 - h; a handle takes 2 more.
void DiscreteModel::requireNoHandle(int num_points, int num_edges, int p, std::string const& name,
                                    std::string const& place) const
{
  std::map<int, std::set<int>> next; // along the border
  for (int c : borders_[p]) {
    auto const& points = curves_[c - 1].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      next[points[i - 1]].insert(points[i]);
      next[points[i]].insert(points[i - 1]);
    }
  }
  int loops = 0, pinches = 0;
  std::set<int> known;
  for (auto const& [start, ends] : next) {
    pinches += static_cast<int>(ends.size()) / 2 - 1;
    std::vector<int> queue;
    if (known.insert(start).second) {
      ++loops;
      queue.push_back(start);
    }
    for (std::size_t k = 0; k < queue.size(); ++k) {
      for (int v : next.at(queue[k])) {
        if (known.insert(v).second) {
          queue.push_back(v);
        }
      }
    }
  }
  const int euler = num_points - num_edges + static_cast<int>(triangles_of_[p].size());
  ASPERITY_REQUIRE(euler + loops + pinches >= 2 || pinches > 0,
                   "'" << name << "' has a handle, as the surface of a ring has, at " << place
                       << ". Cut it into surfaces with a name each.");
}

void DiscreteModel::addElements() const
{
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    std::vector<std::size_t> ends;
    auto const& points = curves_[c].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      ends.insert(ends.end(), {tagOf(points[i - 1]), tagOf(points[i])});
    }
    model::mesh::addElementsByType(static_cast<int>(c) + 1, type_segment, {}, ends);
  }
  for (std::size_t p = 0; p < triangles_of_.size(); ++p) {
    std::vector<std::size_t> corners;
    for (int i : triangles_of_[p]) {
      for (int v : complex_.triangles[i]) {
        corners.push_back(tagOf(v));
      }
    }
    model::mesh::addElementsByType(static_cast<int>(p) + 1, type_triangle, {}, corners);
  }
}

void DiscreteModel::addVolume()
{
  std::vector<int> shell;
  for (std::size_t p = 0; p < patches_.list.size(); ++p) {
    (model_.isFault(patches_.list[p].surface) ? faults_ : shell).push_back(static_cast<int>(p) + 1);
  }
  volume_ = model::geo::addVolume({model::geo::addSurfaceLoop(shell)});
  model::geo::synchronize();
}

void DiscreteModel::embed() const
{
  model::mesh::embed(2, faults_, 3, volume_);
  for (std::size_t p = 0; p < triangles_of_.size(); ++p) {
    const int tag = static_cast<int>(p) + 1;
    if (!inner_[p].empty()) {
      model::mesh::embed(1, inner_[p], 2, tag);
    }
    if (!touched_[p].empty()) {
      model::mesh::embed(0, touched_[p], 2, tag);
    }
  }
}
} // namespace asperity::geometry
