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
    const Facet key = sorted(facet);
    const auto first =
      std::lower_bound(entries_.begin(), entries_.end(), key,
                       [](Entry const& entry, Facet const& wanted) { return entry.key < wanted; });
    auto last = first;
    while (last != entries_.end() && last->key == key) {
      ++last;
    }
    return {first, last};
  }

private:
  std::vector<Entry> entries_;
};
} // namespace asperity::mesh::detail
