#include "meshing/EdgeDivision.hpp"

#include "arrangement/complex/Complex.hpp"
#include "meshing/CellAngles.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace
{
using Cell = std::array<int, 4>;
using Ring = std::vector<int>; // the cells around an edge

class EdgeDivision
{
public:
  EdgeDivision(GlobalMesh<3>& mesh, double wanted) : mesh_(mesh)
  {
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      const double angle = orientedAngle(mesh::corners<3>(mesh.vertices, mesh.cells[c]));
      if (angle < wanted) {
        flat_.emplace_back(angle, static_cast<int>(c));
        for (int v : mesh.cells[c]) {
          around_[v];
        }
      }
    }
    std::sort(flat_.begin(), flat_.end());
    for (std::size_t c = 0; c < mesh.cells.size() && !flat_.empty(); ++c) {
      addTo(static_cast<int>(c));
    }
    for (auto const& [name, facets] : mesh.boundaries) {
      for (auto const& facet : facets) {
        for (int k = 0; k < 3; ++k) {
          const auto edge = edgeOf(facet, k);
          if (around_.count(edge[0]) > 0 && around_.count(edge[1]) > 0) {
            on_surfaces_.insert(edge);
          }
        }
      }
    }
  }

  int run()
  {
    int number = 0;
    for (auto const& [angle, cell] : flat_) {
      number += repair(cell) ? 1 : 0;
    }
    return number;
  }

private:
  struct Division
  {
    Edge edge{};
    Ring ring;
    Point<3> place{};
    double angle = 0; // the smallest around it
  };

  void addTo(int cell)
  {
    for (int v : mesh_.cells[cell]) {
      const auto found = around_.find(v);
      if (found != around_.end()) {
        found->second.insert(cell);
      }
    }
  }

  // Divides the edge of the cell that increases the smallest angle most; false if none does.
  bool repair(int cell)
  {
    constexpr double better = 0.5; // degrees
    const auto corners = mesh_.cells[cell];
    Division best;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        const auto edge = edgeOf(corners[i], corners[j]);
        if (on_surfaces_.count(edge) == 0) {
          const auto division = divisionOf(edge);
          best = division.angle > best.angle ? division : best;
        }
      }
    }
    if (best.ring.empty() || best.angle < smallestOf(best.ring) + better) {
      return false;
    }
    apply(best);
    return true;
  }

  double smallestOf(Ring const& ring) const
  {
    double smallest = 180;
    for (int c : ring) {
      smallest =
        std::min(smallest, orientedAngle(mesh::corners<3>(mesh_.vertices, mesh_.cells[c])));
    }
    return smallest;
  }

  // The best of random places, which are drawn closer and closer to the best one so far.
  Division divisionOf(Edge const& edge)
  {
    constexpr int tries = 40;
    Division division;
    division.edge = edge;
    auto const& first = around_.at(edge[0]);
    auto const& second = around_.at(edge[1]);
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                          std::back_inserter(division.ring));
    auto const& a = mesh_.vertices[edge[0]];
    auto const& b = mesh_.vertices[edge[1]];
    for (int d = 0; d < 3; ++d) {
      division.place[d] = 0.5 * (a[d] + b[d]);
    }
    division.angle = angleWith(division, division.place);
    const double length = mesh::distance<3>(a, b);
    for (double step : {0.6, 0.3, 0.15, 0.07}) {
      for (int i = 0; i < tries; ++i) {
        auto place = division.place;
        for (double& x : place) {
          x += step * length * (2 * double(random_()) / double(std::mt19937::max()) - 1);
        }
        const double angle = angleWith(division, place);
        if (angle > division.angle) {
          division.angle = angle;
          division.place = place;
        }
      }
    }
    return division;
  }

  double angleWith(Division const& division, Point<3> const& place) const
  {
    double smallest = 180;
    for (int c : division.ring) {
      for (int end : division.edge) {
        auto x = mesh::corners<3>(mesh_.vertices, mesh_.cells[c]);
        for (int k = 0; k < 4; ++k) {
          x[k] = mesh_.cells[c][k] == end ? place : x[k];
        }
        smallest = std::min(smallest, orientedAngle(x));
      }
    }
    return smallest;
  }

  void apply(Division const& division)
  {
    const auto vertex = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.push_back(division.place);
    around_[vertex];
    const auto [first, second] = division.edge;
    for (int c : division.ring) {
      auto other = mesh_.cells[c];
      std::replace(mesh_.cells[c].begin(), mesh_.cells[c].end(), second, vertex);
      std::replace(other.begin(), other.end(), first, vertex);
      around_.at(second).erase(c);
      mesh_.cells.push_back(other);
      mesh_.cell_regions.push_back(mesh_.cell_regions[c]);
      addTo(c);
      addTo(static_cast<int>(mesh_.cells.size()) - 1);
    }
  }

  GlobalMesh<3>& mesh_;
  std::vector<std::pair<double, int>> flat_; // angle, cell
  std::map<int, std::set<int>> around_;      // the cells at vertices of flat ones
  std::set<Edge> on_surfaces_;
  std::mt19937 random_; // with the default seed, so that meshes are reproducible
};
} // namespace

int divideEdges(GlobalMesh<3>& mesh, double wanted) { return EdgeDivision(mesh, wanted).run(); }
} // namespace asperity::geometry
