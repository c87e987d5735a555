#include "mesh/generation/PeriodicMesh.hpp"

#include "base/Errors.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/FacetTable.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace asperity::mesh
{
namespace
{
// Finds vertices by their coordinates, up to a tolerance.
template <int Dim>
class PointTable
{
public:
  PointTable(std::vector<Point<Dim>> const& vertices, std::vector<int> const& chosen,
             double tolerance)
      : vertices_(vertices)
      , tolerance_(tolerance)
  {
    for (int vertex : chosen) {
      numbers_.emplace(boxOf(vertices[vertex]), vertex);
    }
  }

  // The chosen vertex at this point, or -1. It lies in the same box or in one beside it.
  int find(Point<Dim> const& point) const
  {
    constexpr int num_boxes = Dim == 2 ? 9 : 27;
    for (int number = 0; number < num_boxes; ++number) {
      auto box = boxOf(point);
      for (int d = 0, digits = number; d < Dim; ++d, digits /= 3) {
        box[d] += digits % 3 - 1;
      }
      const auto [first, last] = numbers_.equal_range(box);
      for (auto entry = first; entry != last; ++entry) {
        if (distance<Dim>(vertices_[entry->second], point) <= tolerance_) {
          return entry->second;
        }
      }
    }
    return -1;
  }

private:
  std::array<long long, Dim> boxOf(Point<Dim> const& point) const
  {
    std::array<long long, Dim> box;
    for (int d = 0; d < Dim; ++d) {
      box[d] = std::llround(point[d] / (2.0 * tolerance_));
    }
    return box;
  }

  std::vector<Point<Dim>> const& vertices_;
  double tolerance_;
  std::multimap<std::array<long long, Dim>, int> numbers_;
};

template <int Dim>
double lowest(GlobalMesh<Dim> const& mesh, std::vector<int> const& vertices, int axis)
{
  double result = std::numeric_limits<double>::infinity();
  for (int vertex : vertices) {
    result = std::min(result, mesh.vertices[vertex][axis]);
  }
  return result;
}

template <int Dim>
void requireShortCells(GlobalMesh<Dim> const& mesh, int axis, double period,
                       std::string const& where)
{
  for (auto const& cell : mesh.cells) {
    const auto points = corners(mesh, cell);
    const auto [first, last] =
      std::minmax_element(points.begin(), points.end(),
                          [axis](auto const& a, auto const& b) { return a[axis] < b[axis]; });
    ASPERITY_REQUIRE((*last)[axis] - (*first)[axis] < 0.499 * period,
                     where << ": a cell is longer than half the period of " << period
                           << " m. At least 3 cells are needed along the axis.");
  }
}

// The new number of every vertex; a vertex of `high` gets that of its translate on `low`.
template <int Dim>
std::vector<int> identified(GlobalMesh<Dim> const& mesh, int axis, double period,
                            std::vector<int> const& low, std::vector<int> const& high,
                            double tolerance, std::string const& where)
{
  std::vector<int> target(mesh.vertices.size(), -1);
  const PointTable<Dim> table(mesh.vertices, low, tolerance);
  for (int vertex : high) {
    auto point = mesh.vertices[vertex];
    point[axis] -= period;
    target[vertex] = table.find(point);
    ASPERITY_REQUIRE(target[vertex] >= 0,
                     where << ": the vertex of the second one at " << text(mesh.vertices[vertex])
                           << " has no counterpart on the first one at a distance of " << period
                           << " m. They have to be translates of each other.");
  }
  std::vector<int> numbers(mesh.vertices.size(), -1);
  int next = 0;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    numbers[v] = target[v] < 0 ? next++ : -1;
  }
  for (int vertex : high) {
    numbers[vertex] = numbers[target[vertex]];
    ASPERITY_REQUIRE(numbers[vertex] >= 0, where << " have a vertex in common.");
  }
  return numbers;
}

template <class Simplices>
void renumber(Simplices& simplices, std::vector<int> const& numbers)
{
  for (auto& simplex : simplices) {
    for (int& vertex : simplex) {
      vertex = numbers[vertex];
    }
  }
}

// `vertices` have to ascend; the others keep their order.
template <int Dim>
void dropVertices(GlobalMesh<Dim>& mesh, std::vector<int> const& vertices)
{
  std::vector<Point<Dim>> kept;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!std::binary_search(vertices.begin(), vertices.end(), static_cast<int>(v))) {
      kept.push_back(mesh.vertices[v]);
    }
  }
  mesh.vertices = std::move(kept);
}

template <int Dim>
void requireSameFacets(GlobalMesh<Dim> const& mesh, std::string const& low, std::string const& high,
                       std::vector<int> const& numbers, std::string const& where)
{
  const auto set_of = [&](std::string const& name) {
    auto facets = mesh.boundaries.at(name);
    renumber(facets, numbers);
    std::set<typename GlobalMesh<Dim>::Facet> result;
    for (auto const& facet : facets) {
      result.insert(detail::sorted(facet));
    }
    return result;
  };
  ASPERITY_REQUIRE(set_of(low) == set_of(high),
                   where << ": their vertices are translates of each other, but not their facets.");
}
} // namespace

template <int Dim>
void makePeriodic(GlobalMesh<Dim>& mesh, int axis, std::string const& low, std::string const& high)
{
  ASPERITY_ASSERT(axis >= 0 && axis < Dim);
  const std::string where = "Mesh: periodic boundaries '" + low + "' and '" + high + "'";
  const auto first = boundaryVertices(mesh, low), second = boundaryVertices(mesh, high);
  ASPERITY_REQUIRE(!first.empty() && first.size() == second.size(),
                   where << " have " << first.size() << " and " << second.size()
                         << " vertices. They have to be translates of each other.");
  const double period = lowest(mesh, second, axis) - lowest(mesh, first, axis);
  ASPERITY_REQUIRE(period > 0.0, where << ": the second one does not lie higher along "
                                       << "xyz"[axis] << " than the first one. Swap them.");
  requireShortCells(mesh, axis, period, where);
  const double tolerance = 1e-6 * std::min(shortestEdge(mesh, low), shortestEdge(mesh, high));
  const auto numbers = identified(mesh, axis, period, first, second, tolerance, where);
  requireSameFacets(mesh, low, high, numbers, where);
  mesh.boundaries.erase(low);
  mesh.boundaries.erase(high);
  renumber(mesh.cells, numbers);
  for (auto& boundary : mesh.boundaries) {
    renumber(boundary.second, numbers);
  }
  dropVertices(mesh, second);
  mesh.period[axis] = period;
}

template void makePeriodic(GlobalMesh<2>&, int, std::string const&, std::string const&);
template void makePeriodic(GlobalMesh<3>&, int, std::string const&, std::string const&);
} // namespace asperity::mesh
