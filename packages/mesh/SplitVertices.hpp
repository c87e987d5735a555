#pragma once

#include "mesh/Crossings.hpp"

#include <unordered_map>

namespace asperity::mesh
{
// The two sides of the facets of faults inside the body, in a mesh that is split, whole or a part.
template <int Dim>
class FaultSides
{
public:
  explicit FaultSides(std::vector<SplitVertex> const& splits)
  {
    for (auto const& pair : splits) {
      pair_of_plus_[pair.plus] = pair;
    }
    for (auto const& crossing : crossingsOf(splits)) {
      crossing_of_plus_.emplace(crossing.plus[0], OfCrossing{crossing, 0});
      crossing_of_plus_.emplace(crossing.plus[1], OfCrossing{crossing, 1});
    }
  }

  // The pair of this plus vertex, or nullptr.
  SplitVertex const* find(int plus) const
  {
    const auto found = pair_of_plus_.find(plus);
    return found == pair_of_plus_.end() ? nullptr : &found->second;
  }

  // The crossing of this plus vertex of a fault, or nullptr.
  Crossing const* findCrossing(int plus) const
  {
    auto const* found = ofCrossing(plus);
    return found ? &found->crossing : nullptr;
  }

  // The facet, or edge of a facet, of the cell on the plus side. At a tip both sides share the
  // vertex minus.
  template <std::size_t N>
  std::array<int, N> plusSide(std::array<int, N> const& facet) const
  {
    static_assert(N <= Dim);
    auto side = facet;
    for (std::size_t i = 0; i < N; ++i) {
      auto const* pair = find(facet[i]);
      side[i] = pair && pair->is_tip ? pair->minus : facet[i];
      if (auto const* crossed = ofCrossing(facet[i])) {
        side[i] = crossed->isBeyond(i) ? crossed->crossing.both : facet[i];
      }
    }
    return side;
  }

  // The facet, or edge of a facet, of the cell on the minus side. It keeps the orientation of the
  // plus side: for the cell on the minus side it is inward.
  template <std::size_t N>
  std::array<int, N> minusSide(std::array<int, N> const& facet) const
  {
    auto side = facet;
    for (std::size_t i = 0; i < N; ++i) {
      auto const* pair = find(facet[i]);
      side[i] = pair ? pair->minus : facet[i];
      auto const* crossed = ofCrossing(facet[i]);
      if (crossed && crossed->isBeyond(i)) {
        side[i] = crossed->crossing.plus[1 - crossed->fault];
      }
    }
    return side;
  }

private:
  struct OfCrossing
  {
    Crossing crossing;
    std::size_t fault; // 0 for the first one, 1 for the second one

    // Whether the facet that has the vertex at this place lies on the plus side of the other fault:
    // that of the first fault ends there, that of the second one begins there.
    bool isBeyond(std::size_t place) const { return place != fault; }
  };

  OfCrossing const* ofCrossing(int plus) const
  {
    const auto found = crossing_of_plus_.find(plus);
    return found == crossing_of_plus_.end() ? nullptr : &found->second;
  }

  std::unordered_map<int, SplitVertex> pair_of_plus_;
  std::unordered_map<int, OfCrossing> crossing_of_plus_;
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
