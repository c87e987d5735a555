#pragma once

#include "mesh/GlobalMesh.hpp"

#include <unordered_map>

namespace asperity::mesh
{
// The two sides of the facets of faults inside the body, in a mesh that is split, whole or a part.
template <int Dim>
class FaultSides
{
public:
  using Facet = typename Mesh<Dim>::Facet;

  explicit FaultSides(std::vector<SplitVertex> const& splits)
  {
    for (auto const& pair : splits) {
      pair_of_plus_[pair.plus] = pair;
    }
  }

  // The pair of this plus vertex, or nullptr.
  SplitVertex const* find(int plus) const
  {
    const auto found = pair_of_plus_.find(plus);
    return found == pair_of_plus_.end() ? nullptr : &found->second;
  }

  // The facet of the cell on the plus side. At a tip both sides share the vertex minus.
  Facet plusSide(Facet facet) const
  {
    for (int& vertex : facet) {
      auto const* pair = find(vertex);
      vertex = pair && pair->is_tip ? pair->minus : vertex;
    }
    return facet;
  }

  // The facet of the cell on the minus side. It keeps the orientation of the plus side: for the
  // cell on the minus side it is inward.
  Facet minusSide(Facet facet) const
  {
    for (int& vertex : facet) {
      auto const* pair = find(vertex);
      vertex = pair ? pair->minus : vertex;
    }
    return facet;
  }

private:
  std::unordered_map<int, SplitVertex> pair_of_plus_;
};

// Pairs as rows of numbers, for MPI, checksums and files: plus, minus, and 1 for a tip or else 0.
using SplitRow = std::array<int, 3>;

inline std::vector<SplitRow> asRows(std::vector<SplitVertex> const& splits)
{
  std::vector<SplitRow> rows;
  rows.reserve(splits.size());
  for (auto const& pair : splits) {
    rows.push_back({pair.plus, pair.minus, pair.is_tip ? 1 : 0});
  }
  return rows;
}

inline std::vector<SplitVertex> fromRows(std::vector<SplitRow> const& rows)
{
  std::vector<SplitVertex> splits;
  splits.reserve(rows.size());
  for (auto const& [plus, minus, is_tip] : rows) {
    splits.push_back({plus, minus, is_tip != 0});
  }
  return splits;
}
} // namespace asperity::mesh
