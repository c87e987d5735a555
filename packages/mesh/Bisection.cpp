#include "mesh/Bisection.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace asperity::mesh
{
namespace
{
constexpr std::size_t most_vertices = 10'000'000;

// Triangles (i, j, k) with refinement edge i-j and newest vertex k. A sweep marks the refinement
// edges of the cells that are too large, marks more until every cell with a marked edge has its
// refinement edge marked too, and bisects along all marked edges. Marking more ends because there
// are finitely many edges, whatever the refinement edges of the first cells are.
class NewestVertexBisection
{
public:
  explicit NewestVertexBisection(GlobalMesh<2> const& mesh) : mesh_(mesh)
  {
    for (auto& cell : mesh_.cells) {
      turnLongestEdgeFirst(cell);
    }
  }

  // False if no cell was too large.
  bool sweep(SizeFunction const& largest_diameter)
  {
    markLargeCells(largest_diameter);
    if (midpoints_.empty()) {
      return false;
    }
    closeMarks();
    createMidpoints();
    bisectCells();
    bisectFacets();
    midpoints_.clear();
    return true;
  }

  GlobalMesh<2> const& mesh() const { return mesh_; }

private:
  using Cell = GlobalMesh<2>::Cell;
  using Facet = GlobalMesh<2>::Facet;
  static constexpr int unknown = -1;

  void turnLongestEdgeFirst(Cell& cell) const
  {
    const auto length = [&](Cell const& c) {
      return distance<2>(mesh_.vertices[c[0]], mesh_.vertices[c[1]]);
    };
    const Cell turned[] = {cell, {cell[1], cell[2], cell[0]}, {cell[2], cell[0], cell[1]}};
    for (auto const& candidate : turned) {
      if (length(candidate) > length(cell)) {
        cell = candidate;
      }
    }
  }

  static std::uint64_t key(int i, int j)
  {
    const auto low = static_cast<std::uint64_t>(std::min(i, j));
    return (low << 32) | static_cast<std::uint64_t>(std::max(i, j));
  }
  bool isMarked(int i, int j) const { return midpoints_.count(key(i, j)) > 0; }
  bool mark(int i, int j) { return midpoints_.emplace(key(i, j), unknown).second; }

  void markLargeCells(SizeFunction const& largest_diameter)
  {
    for (auto const& cell : mesh_.cells) {
      const auto triangle = corners<2>(mesh_.vertices, cell);
      const double allowed = largest_diameter(triangle);
      ASPERITY_ASSERT(allowed > 0.0);
      if (longestEdge(triangle) > allowed) {
        mark(cell[0], cell[1]);
      }
    }
  }

  void closeMarks()
  {
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (auto const& [i, j, k] : mesh_.cells) {
        if ((isMarked(j, k) || isMarked(k, i)) && mark(i, j)) {
          has_changed = true;
        }
      }
    }
  }

  // In the order of the cells, so that the numbers do not depend on the hash table.
  void createMidpoints()
  {
    for (auto const& cell : mesh_.cells) {
      for (int e = 0; e < 3; ++e) {
        createMidpoint(cell[e], cell[(e + 1) % 3]);
      }
    }
  }

  void createMidpoint(int i, int j)
  {
    const auto found = midpoints_.find(key(i, j));
    if (found != midpoints_.end() && found->second == unknown) {
      auto const &a = mesh_.vertices[i], &b = mesh_.vertices[j];
      found->second = static_cast<int>(mesh_.vertices.size());
      mesh_.vertices.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])});
    }
  }

  void bisectCells()
  {
    std::vector<Cell> cells;
    std::vector<int> regions;
    cells.swap(mesh_.cells);
    regions.swap(mesh_.cell_regions);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      bisectCell(cells[c], regions[c]);
    }
  }

  void bisectCell(Cell const& cell, int region)
  {
    const auto [i, j, k] = cell;
    const auto found = midpoints_.find(key(i, j));
    if (found == midpoints_.end()) {
      mesh_.cells.push_back(cell);
      mesh_.cell_regions.push_back(region);
      return;
    }
    const int newest = found->second;
    bisectCell({k, i, newest}, region);
    bisectCell({j, k, newest}, region);
  }

  void bisectFacets()
  {
    for (auto& [name, facets] : mesh_.boundaries) {
      std::vector<Facet> halves;
      for (auto const& [i, j] : facets) {
        const auto found = midpoints_.find(key(i, j));
        if (found == midpoints_.end()) {
          halves.push_back({i, j});
        } else {
          halves.push_back({i, found->second});
          halves.push_back({found->second, j});
        }
      }
      facets = std::move(halves);
    }
  }

  GlobalMesh<2> mesh_;
  std::unordered_map<std::uint64_t, int> midpoints_; // marked edge -> vertex, or unknown
};

// Fewer vertices than a triangle will have: none of its cells is larger than an equilateral one of
// the largest diameter allowed at its corners, and there are two cells a vertex. Where that varies,
// its quarters are asked.
double fewestVertices(Triangle const& t, SizeFunction const& largest_diameter, int depth)
{
  std::array<double, 3> allowed{};
  for (int i = 0; i < 3; ++i) {
    allowed[i] = largest_diameter({t[i], t[i], t[i]});
  }
  const auto [smallest, largest] = std::minmax_element(allowed.begin(), allowed.end());
  if (depth == 0 || *largest <= 2.0 * *smallest) {
    const double largest_cell = 0.25 * std::sqrt(3.0) * *largest * *largest;
    return 0.5 * std::abs(signedMeasure(t)) / largest_cell;
  }
  const auto middle = [&t](int i, int j) {
    return Point<2>{0.5 * (t[i][0] + t[j][0]), 0.5 * (t[i][1] + t[j][1])};
  };
  const Point<2> a = middle(1, 2), b = middle(2, 0), c = middle(0, 1);
  double sum = 0.0;
  for (Triangle const& quarter :
       {Triangle{t[0], c, b}, Triangle{c, t[1], a}, Triangle{b, a, t[2]}, Triangle{a, b, c}}) {
    sum += fewestVertices(quarter, largest_diameter, depth - 1);
  }
  return sum;
}

// Before hours of bisection, not after them.
void refuseTooMany(GlobalMesh<2> const& mesh, SizeFunction const& largest_diameter)
{
  constexpr int depth = 6;
  double sum = 0.0;
  for (auto const& cell : mesh.cells) {
    sum += fewestVertices(corners<2>(mesh.vertices, cell), largest_diameter, depth);
  }
  ASPERITY_REQUIRE(sum <= most_vertices, "Mesh: cells of this size would have about "
                                           << formatShort(sum) << " vertices, more than "
                                           << most_vertices << ". Is the cell size meant in m?");
}
} // namespace

GlobalMesh<2> bisect(GlobalMesh<2> const& mesh, SizeFunction const& largest_diameter)
{
  refuseTooMany(mesh, largest_diameter);
  NewestVertexBisection bisection(mesh);
  while (bisection.sweep(largest_diameter)) {
    ASPERITY_REQUIRE(bisection.mesh().vertices.size() <= most_vertices,
                     "Mesh: the cells would have more than "
                       << most_vertices << " vertices. Is the cell size meant in m?");
  }
  return bisection.mesh();
}

SizeFunction largestDiameter(CellSize const& size)
{
  return [size](Triangle const& cell) {
    double smallest = size(centroid(cell));
    for (int i = 0; i < 3; ++i) {
      auto const &a = cell[i], &b = cell[(i + 1) % 3];
      smallest = std::min({smallest, size(a), size({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])})});
    }
    constexpr double rounding = 1e-9;
    return std::sqrt(2.0) * (1.0 + rounding) * smallest;
  };
}
} // namespace asperity::mesh
