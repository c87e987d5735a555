#pragma once

#include "mesh/detail/FacetTable.hpp"

#include <functional>
#include <numeric>

namespace asperity::mesh::detail
{
// The cells around a vertex or an edge, and how the facets there connect them.
template <int Dim>
class Star
{
public:
  using Cell = typename GlobalMesh<Dim>::Cell;
  using Facet = typename GlobalMesh<Dim>::Facet;

  // `around` are the numbers of the cells that have all vertices in `centre`;
  // fault_facet(sorted facet) is the number of a facet of a fault, or -1 for any other one.
  template <std::size_t N>
  Star(std::vector<Cell> const& cells, std::vector<int> const& around,
       std::array<int, N> const& centre, std::function<int(Facet const&)> const& fault_facet)
      : cells_(around)
  {
    std::vector<std::pair<Facet, int>> facets; // with the cell's place in `around`
    for (std::size_t c = 0; c < around.size(); ++c) {
      auto const& cell = cells[static_cast<std::size_t>(around[c])];
      for (int corner = 0; corner <= Dim; ++corner) {
        if (std::find(centre.begin(), centre.end(), cell[corner]) == centre.end()) {
          facets.emplace_back(sorted(oppositeFacet(cell, corner)), static_cast<int>(c));
        }
      }
    }
    std::sort(facets.begin(), facets.end());
    for (std::size_t f = 1; f < facets.size(); ++f) {
      if (facets[f].first == facets[f - 1].first) {
        links_.push_back({facets[f - 1].second, facets[f].second, fault_facet(facets[f].first)});
      }
    }
  }

  std::vector<int> const& cells() const { return cells_; }

  // The cells in sets that are connected across facets other than those cut.
  struct Sets
  {
    std::vector<int> set_of_cell; // (cells().size()), the number of its set
    int count = 0;
  };
  Sets cut(std::function<bool(int fault_facet)> const& is_cut) const
  {
    std::vector<int> root(cells_.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&root](int cell) {
      while (root[cell] != cell) {
        cell = root[cell];
      }
      return cell;
    };
    for (auto const& link : links_) {
      if (link.fault_facet < 0 || !is_cut(link.fault_facet)) {
        const auto [low, high] = std::minmax({find(link.a), find(link.b)});
        root[high] = low;
      }
    }
    Sets sets;
    sets.set_of_cell.resize(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const int first = find(static_cast<int>(c)); // the first cell of the set, at most c
      sets.set_of_cell[c] = first == static_cast<int>(c) ? sets.count++ : sets.set_of_cell[first];
    }
    return sets;
  }

private:
  struct Link
  {
    int a, b; // places of two cells that share a facet
    int fault_facet;
  };
  std::vector<int> cells_;
  std::vector<Link> links_;
};
} // namespace asperity::mesh::detail
