#include "meshing/Relocation.hpp"

#include "arrangement/complex/Complex.hpp"
#include "arrangement/complex/Curves.hpp"
#include "arrangement/complex/TriangleTree.hpp"
#include "meshing/CellAngles.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace
{
// What tree_of_ says of a vertex, unless it is the tree on which the vertex has to stay.
constexpr int is_free = -1, is_fixed = -2;

class Relocation
{
public:
  Relocation(GlobalMesh<3>& mesh, Complex const& complex, Model const& model)
      : mesh_(mesh)
      , tree_of_(mesh.vertices.size(), is_free)
      , around_(mesh.vertices.size())
  {
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      for (int v : mesh.cells[c]) {
        around_[v].push_back(static_cast<int>(c));
      }
    }
    std::vector<std::vector<Triangle>> triangles(model.surfaces.size());
    for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
      triangles[complex.surfaces[i]].push_back(complex.triangles[i]);
    }
    std::vector<std::set<int>> surfaces(mesh.vertices.size());
    std::set<int> on_curves;
    for (int s = 0; s < static_cast<int>(model.surfaces.size()); ++s) {
      trees_.emplace_back(complex.points, triangles[s]);
      auto const& facets = mesh.boundaries.at(model.name(s));
      for (auto const& facet : facets) {
        for (int v : facet) {
          surfaces[v].insert(s);
          tree_of_[v] = s;
        }
      }
      for (auto const& [edge, around] : trianglesAtEdges(facets)) {
        if (around.size() != 2) {
          on_curves.insert(edge.begin(), edge.end());
        }
      }
    }
    for (std::size_t v = 0; v < surfaces.size(); ++v) {
      if (surfaces[v].size() > 1) {
        on_curves.insert(static_cast<int>(v));
      }
    }
    constrainToCurves(complex, surfaces, on_curves);
  }

  int run(double wanted)
  {
    constexpr int most_rounds = 10;
    auto bad = cellsBelow(wanted);
    for (int round = 0; round < most_rounds && !bad.empty(); ++round) {
      bool is_changed = false;
      for (auto const& [angle, cell] : bad) {
        for (int v : mesh_.cells[cell]) {
          is_changed = improve(v) || is_changed;
        }
      }
      bad = cellsBelow(wanted);
      if (!is_changed) {
        break;
      }
    }
    return static_cast<int>(bad.size());
  }

private:
  // A vertex lies inside a curve if it lies on all surfaces of the curve and is not one of its
  // ends.
  void constrainToCurves(Complex const& complex, std::vector<std::set<int>> const& surfaces,
                         std::set<int> const& on_curves)
  {
    std::map<std::set<int>, std::vector<Triangle>> segments;
    std::vector<Triangle> corners;
    for (auto const& curve : findCurves(complex)) {
      auto& of_surfaces = segments[std::set<int>(curve.surfaces.begin(), curve.surfaces.end())];
      for (std::size_t i = 1; i < curve.points.size(); ++i) {
        of_surfaces.push_back({curve.points[i - 1], curve.points[i], curve.points[i]});
      }
      for (int v : {curve.points.front(), curve.points.back()}) {
        corners.push_back({v, v, v});
      }
    }
    std::map<std::set<int>, int> tree_of_surfaces;
    for (auto const& [of_curve, list] : segments) {
      tree_of_surfaces[of_curve] = static_cast<int>(trees_.size());
      trees_.emplace_back(complex.points, list);
    }
    const TriangleTree ends(complex.points, corners);
    const double rounding = 1e-8 * extentOf(complex.points);
    for (int v : on_curves) {
      const auto found = tree_of_surfaces.find(surfaces[v]);
      const auto& place = mesh_.vertices[v];
      const bool is_corner = ends.nearest(place).distance < rounding;
      tree_of_[v] = found == tree_of_surfaces.end() || is_corner ||
                        trees_[found->second].nearest(place).distance > rounding
                      ? is_fixed
                      : found->second;
    }
  }

  std::vector<std::pair<double, int>> cellsBelow(double wanted) const
  {
    std::vector<std::pair<double, int>> cells;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      const double angle = angleOf(static_cast<int>(c));
      if (angle < wanted) {
        cells.emplace_back(angle, static_cast<int>(c));
      }
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  double angleOf(int cell) const
  {
    return orientedAngle(mesh::corners<3>(mesh_.vertices, mesh_.cells[cell]));
  }

  double smallestAround(int v) const
  {
    double smallest = 180;
    for (int c : around_[v]) {
      smallest = std::min(smallest, angleOf(c));
    }
    return smallest;
  }

  double shortestEdge(int v) const
  {
    double shortest = std::numeric_limits<double>::infinity();
    for (int c : around_[v]) {
      for (int w : mesh_.cells[c]) {
        if (w != v) {
          shortest = std::min(shortest, mesh::distance<3>(mesh_.vertices[v], mesh_.vertices[w]));
        }
      }
    }
    return shortest;
  }

  // Tries random places around the vertex, at smaller and smaller distances.
  bool improve(int v)
  {
    constexpr int tries = 12;
    constexpr double better = 1e-3; // degrees
    if (tree_of_[v] == is_fixed) {
      return false;
    }
    const double edge = shortestEdge(v);
    bool is_changed = false;
    double best = smallestAround(v);
    for (double step : {0.4, 0.2, 0.1, 0.05}) {
      for (int i = 0; i < tries; ++i) {
        const auto before = mesh_.vertices[v];
        auto place = before;
        for (double& x : place) {
          x += step * edge * (2 * double(random_()) / double(std::mt19937::max()) - 1);
        }
        mesh_.vertices[v] =
          tree_of_[v] == is_free ? place : trees_[tree_of_[v]].nearest(place).point;
        const double angle = smallestAround(v);
        if (angle > best + better) {
          best = angle;
          is_changed = true;
        } else {
          mesh_.vertices[v] = before;
        }
      }
    }
    return is_changed;
  }

  GlobalMesh<3>& mesh_;
  std::vector<int> tree_of_;             // (num_vertices)
  std::vector<std::vector<int>> around_; // (num_vertices) cells
  std::vector<TriangleTree> trees_;      // of surfaces, then of curves
  std::mt19937 random_;                  // with the default seed, so that meshes are reproducible
};
} // namespace

int relocateVertices(GlobalMesh<3>& mesh, Complex const& complex, Model const& model, double wanted)
{
  return Relocation(mesh, complex, model).run(wanted);
}
} // namespace asperity::geometry
