#pragma once

#include "mesh/GlobalMesh.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace asperity::mesh::detail
{
// A cell's facet opposite to one of its corners, outward if the cell is positively oriented.
inline std::array<int, 2> oppositeFacet(std::array<int, 3> const& cell, int corner)
{
  return {cell[(corner + 1) % 3], cell[(corner + 2) % 3]};
}
inline std::array<int, 3> oppositeFacet(std::array<int, 4> const& cell, int corner)
{
  constexpr int facets[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  auto const& f = facets[corner];
  return {cell[f[0]], cell[f[1]], cell[f[2]]};
}

template <class Number, std::size_t N>
std::array<Number, N> sorted(std::array<Number, N> simplex)
{
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

// The facets of all cells, to be found by their vertices in any order.
template <int Dim>
class FacetTable
{
public:
  using Cell = typename GlobalMesh<Dim>::Cell;
  using Facet = typename GlobalMesh<Dim>::Facet;
  struct Entry
  {
    Facet key; // sorted vertices
    int cell;
    Facet outward;
  };
  using Iterator = typename std::vector<Entry>::const_iterator;

  explicit FacetTable(std::vector<Cell> const& cells)
  {
    entries_.reserve(cells.size() * (Dim + 1));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      for (int corner = 0; corner <= Dim; ++corner) {
        const Facet facet = oppositeFacet(cells[c], corner);
        entries_.push_back({sorted(facet), static_cast<int>(c), facet});
      }
    }
    std::sort(entries_.begin(), entries_.end(), [](Entry const& a, Entry const& b) {
      return std::tie(a.key, a.cell) < std::tie(b.key, b.cell);
    });
  }

  // Sorted by key, so that the two entries of a shared facet are neighbours.
  std::vector<Entry> const& entries() const { return entries_; }

  std::pair<Iterator, Iterator> find(Facet const& facet) const
  {
    const auto first =
      std::lower_bound(entries_.begin(), entries_.end(), sorted(facet),
                       [](Entry const& entry, Facet const& wanted) { return entry.key < wanted; });
    return {first, endOf(first, sorted(facet))};
  }

  // The entries of the facets that only one cell has.
  std::vector<Entry const*> outerEntries() const
  {
    std::vector<Entry const*> found;
    for (auto first = entries_.begin(); first != entries_.end();) {
      const auto last = endOf(first, first->key);
      if (last - first == 1) {
        found.push_back(&*first);
      }
      first = last;
    }
    return found;
  }

private:
  Iterator endOf(Iterator first, Facet const& key) const
  {
    return std::find_if(first, entries_.end(),
                        [&](Entry const& entry) { return entry.key != key; });
  }

  std::vector<Entry> entries_;
};

// The number of a vertex in the whole mesh.
template <int Dim>
GlobalOrdinal globalId(GlobalMesh<Dim> const&, int vertex)
{
  return vertex;
}
template <int Dim>
GlobalOrdinal globalId(Mesh<Dim> const& part, int vertex)
{
  return part.global_ids[static_cast<std::size_t>(vertex)];
}

// The number of vertices, the first ones, of which all cells are here.
template <int Dim>
int numComplete(GlobalMesh<Dim> const& mesh)
{
  return static_cast<int>(mesh.vertices.size());
}
template <int Dim>
int numComplete(Mesh<Dim> const& part)
{
  return part.num_owned;
}
} // namespace asperity::mesh::detail
