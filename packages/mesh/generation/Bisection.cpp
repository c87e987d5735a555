#include "mesh/generation/Bisection.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/FacetTable.hpp"
#include "mesh/generation/detail/MarkedSimplex.hpp"
#include "mesh/generation/detail/VertexEstimate.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace asperity::mesh
{
namespace
{
using detail::Edge;

struct EdgeHash
{
  std::size_t operator()(Edge const& edge) const
  {
    return splitMix((static_cast<std::uint64_t>(edge[0]) << 32) |
                    static_cast<std::uint64_t>(edge[1]));
  }
};

// A sweep marks the refinement edges of the cells that are too large, marks more until every cell
// with a marked edge has its refinement edge marked too, and bisects along all marked edges.
// This ends because there are finitely many edges, for every choice of the refinement edges of the
// first cells. Triangles are then conforming. Tetrahedra may have children with a marked edge that
// is not their refinement edge; for this reason marking and bisection repeat until none has one.
template <int Dim>
class Bisection
{
public:
  explicit Bisection(GlobalMesh<Dim> const& mesh) : mesh_(mesh)
  {
    const detail::IsLonger is_longer = [this](Edge const& a, Edge const& b) {
      return rank(a) > rank(b);
    };
    cells_.reserve(mesh.cells.size());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      cells_.push_back({{mesh.cells[c], is_longer}, mesh.cell_regions[c], false});
    }
    for (auto const& [name, facets] : mesh.boundaries) {
      auto& marked = facets_[name];
      for (auto const& facet : facets) {
        marked.push_back({facet, is_longer});
      }
    }
  }

  // Returns false if no cell was too large.
  bool sweep(SizeFunction<Dim> const& largest_diameter)
  {
    markLargeCells(largest_diameter);
    if (midpoints_.empty()) {
      return false;
    }
    closeMarks();
    do {
      createMidpoints();
      bisectCells();
    } while (closeMarks());
    bisectFacets();
    midpoints_.clear();
    return true;
  }

  std::size_t numVertices() const { return mesh_.vertices.size(); }

  GlobalMesh<Dim> mesh() const
  {
    auto result = mesh_;
    result.cells.clear();
    result.cell_regions.clear();
    for (auto const& cell : cells_) {
      result.cells.push_back(cell.simplex.vertices());
      result.cell_regions.push_back(cell.region);
    }
    for (auto& [name, facets] : result.boundaries) {
      facets.clear();
      for (auto const& facet : facets_.at(name)) {
        facets.push_back(facet.vertices());
      }
    }
    return result;
  }

private:
  using Simplex = detail::MarkedSimplex<Dim>;
  using Facet = detail::MarkedSimplex<Dim - 1>;
  struct Cell
  {
    Simplex simplex;
    int region;
    bool is_small; // whether it is known to be small enough
  };
  static constexpr int unknown = -1;

  // A strict order of the edges by their length.
  std::tuple<double, int, int> rank(Edge edge) const
  {
    edge = detail::sorted(edge);
    return {longestEdge(corners(mesh_, edge)), edge[0], edge[1]};
  }

  static Edge edgeOf(Simplex const& simplex, Edge const& ends)
  {
    return {simplex.vertices()[ends[0]], simplex.vertices()[ends[1]]};
  }

  void markLargeCells(SizeFunction<Dim> const& largest_diameter)
  {
    for (auto& cell : cells_) {
      if (!cell.is_small) {
        const auto points = corners(mesh_, cell.simplex.vertices());
        const double allowed = largest_diameter(points);
        ASPERITY_REQUIRE(allowed > 0.0,
                         "Mesh: the cell size is not a positive number everywhere. Check Cell "
                         "Size, Growth Factor and Growth Length: one is far too large or too "
                         "small.");
        cell.is_small = longestEdge(points) <= allowed;
      }
      if (!cell.is_small) {
        mark(cell.simplex.refinementEdge());
      }
    }
  }

  // Returns false if the edge is marked already.
  bool mark(Edge const& edge) { return midpoints_.emplace(detail::sorted(edge), unknown).second; }

  // nullptr if the edge is not marked.
  int* midpointOf(Edge const& edge)
  {
    const auto found = midpoints_.find(detail::sorted(edge));
    return found == midpoints_.end() ? nullptr : &found->second;
  }

  bool hasMarkedEdge(Simplex const& simplex)
  {
    return std::any_of(Simplex::edges.begin(), Simplex::edges.end(),
                       [&](Edge const& ends) { return midpointOf(edgeOf(simplex, ends)); });
  }

  // Returns false if every cell with a marked edge had its refinement edge marked already.
  bool closeMarks()
  {
    bool has_marked = false;
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (auto const& cell : cells_) {
        if (hasMarkedEdge(cell.simplex) && mark(cell.simplex.refinementEdge())) {
          has_changed = true;
        }
      }
      has_marked = has_marked || has_changed;
    }
    return has_marked;
  }

  // Midpoints are numbered in the order of the cells, and not in that of the hash table.
  void createMidpoints()
  {
    for (auto const& cell : cells_) {
      for (auto const& ends : Simplex::edges) {
        const Edge edge = edgeOf(cell.simplex, ends);
        int* midpoint = midpointOf(edge);
        if (midpoint && *midpoint == unknown) {
          *midpoint = static_cast<int>(mesh_.vertices.size());
          mesh_.vertices.push_back(centroid(corners(mesh_, edge)));
        }
      }
    }
  }

  void bisectCells()
  {
    std::vector<Cell> cells;
    cells.swap(cells_);
    cells_.reserve(2 * cells.size());
    for (auto const& cell : cells) {
      const bool is_whole = !midpointOf(cell.simplex.refinementEdge());
      forPieces(cell.simplex, [&](Simplex const& piece) {
        cells_.push_back({piece, cell.region, cell.is_small && is_whole});
      });
    }
  }

  void bisectFacets()
  {
    for (auto& boundary : facets_) {
      std::vector<Facet> facets;
      facets.swap(boundary.second);
      for (auto const& facet : facets) {
        forPieces(facet, [&](Facet const& piece) { boundary.second.push_back(piece); });
      }
    }
  }

  // Calls visit(piece) for what bisection along the marked edges makes of a cell or a facet.
  template <class AnySimplex, class Visit>
  void forPieces(AnySimplex const& simplex, Visit const& visit)
  {
    int const* midpoint = midpointOf(simplex.refinementEdge());
    if (!midpoint) {
      visit(simplex);
      return;
    }
    for (auto const& child : simplex.children(*midpoint)) {
      forPieces(child, visit);
    }
  }

  GlobalMesh<Dim> mesh_; // current vertices; cells and boundaries of the given mesh
  std::vector<Cell> cells_;
  std::map<std::string, std::vector<Facet>> facets_;
  std::unordered_map<Edge, int, EdgeHash>
    midpoints_; // marked edge, ascending -> vertex, or unknown
};

} // namespace

void requirePositive(double value, std::string const& name)
{
  ASPERITY_REQUIRE(value > 0.0 && std::isfinite(value),
                   "Mesh / " << name << " = " << value << " is outside (0, inf).");
}

void requireFewVertices(double num_vertices, VertexLimit const& limit)
{
  ASPERITY_REQUIRE(num_vertices <= limit.most,
                   "Mesh: about " << formatShort(num_vertices) << " vertices are too many; at most "
                                  << std::to_string(static_cast<long long>(limit.most))
                                  << " are allowed. " << limit.advice);
}

template <int Dim>
GlobalMesh<Dim> bisect(GlobalMesh<Dim> const& mesh, SizeFunction<Dim> const& largest_diameter,
                       VertexLimit const& limit)
{
  // Too small a size is refused before the bisection, which might take hours.
  const double fewest = detail::fewestVertices<Dim>(mesh, largest_diameter);
  ASPERITY_REQUIRE(!std::isnan(fewest), "Mesh: the number of cells cannot be counted. Check the "
                                        "extents of the body and Cell Size: one is too large.");
  requireFewVertices(fewest, limit);
  Bisection<Dim> bisection(mesh);
  while (bisection.sweep(largest_diameter)) {
    ASPERITY_REQUIRE(static_cast<double>(bisection.numVertices()) <= limit.most,
                     "Mesh: the cells would have more than "
                       << std::to_string(static_cast<long long>(limit.most)) << " vertices. "
                       << limit.advice);
  }
  return bisection.mesh();
}

template <int Dim>
SizeFunction<Dim> largestDiameter(CellSize<Dim> const& size)
{
  return [size](std::array<Point<Dim>, Dim + 1> const& cell) {
    double smallest = size(centroid(cell));
    for (int i = 0; i <= Dim; ++i) {
      smallest = std::min(smallest, size(cell[i]));
      for (int j = 0; j < i; ++j) {
        smallest = std::min(smallest, size(centroid(std::array<Point<Dim>, 2>{cell[i], cell[j]})));
      }
    }
    constexpr double rounding = 1e-9;
    return std::sqrt(double(Dim)) * (1.0 + rounding) * smallest;
  };
}

template <int Dim>
GlobalMesh<Dim> bisectBricks(GlobalMesh<Dim> mesh, Point<Dim> const& brick,
                             CellSize<Dim> const& size, VertexLimit const& limit)
{
  Point<Dim> stretch;
  for (int axis = 0; axis < Dim; ++axis) {
    stretch[axis] = *std::max_element(brick.begin(), brick.end()) / brick[axis];
  }
  const auto scaled = [&stretch](Point<Dim> x, bool back) {
    for (int axis = 0; axis < Dim; ++axis) {
      x[axis] = back ? x[axis] / stretch[axis] : x[axis] * stretch[axis];
    }
    return x;
  };
  const auto scaleAll = [&scaled](GlobalMesh<Dim>& all, bool back) {
    for (auto& x : all.vertices) {
      x = scaled(x, back);
    }
    all.period = scaled(all.period, back);
  };
  scaleAll(mesh, false);
  mesh = bisect<Dim>(
    mesh, largestDiameter<Dim>([&](Point<Dim> const& x) { return size(scaled(x, true)); }), limit);
  scaleAll(mesh, true);
  return mesh;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template GlobalMesh<Dim> bisect<Dim>(GlobalMesh<Dim> const&, SizeFunction<Dim> const&,           \
                                       VertexLimit const&);                                        \
  template SizeFunction<Dim> largestDiameter<Dim>(CellSize<Dim> const&);                           \
  template GlobalMesh<Dim> bisectBricks<Dim>(GlobalMesh<Dim>, Point<Dim> const&,                   \
                                             CellSize<Dim> const&, VertexLimit const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh
