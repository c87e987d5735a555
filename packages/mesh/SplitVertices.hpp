#pragma once

#include "mesh/Crossings.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace asperity::mesh
{
// The pairs of a mesh that is split, whole or a part, by their plus vertices.
class FaultPairs
{
public:
  // A crossing, and 0 for its first fault or 1 for its second one.
  struct OfCrossing
  {
    Crossing crossing;
    int fault;
    int other() const { return crossing.plus[1 - fault]; } // the plus vertex of the other fault
  };

  explicit FaultPairs(std::vector<SplitVertex> const& splits)
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
  OfCrossing const* findCrossing(int plus) const
  {
    const auto found = crossing_of_plus_.find(plus);
    return found == crossing_of_plus_.end() ? nullptr : &found->second;
  }

  // The vertex that stands for all vertices at a place of faults: the one that is the plus of no
  // pair. A vertex apart from faults stands for itself.
  int placeOf(int vertex) const
  {
    while (auto const* pair = find(vertex)) {
      vertex = pair->minus;
    }
    return vertex;
  }

  bool haveCrossings() const { return !crossing_of_plus_.empty(); }

private:
  std::unordered_map<int, SplitVertex> pair_of_plus_;
  std::unordered_map<int, OfCrossing> crossing_of_plus_;
};

// The two sides of the facets of faults inside the body, in a mesh that is split, whole or a part
// that has the cells on both sides of its facets.
//
// At a crossing the facets of a fault have one plus vertex, but lie on the minus side or on the
// plus side of the other fault, and their cells have other copies there. Which ones they are is
// looked up among the cells: of the two cells at a facet one lies on its plus side.
template <int Dim>
class FaultSides
{
public:
  using Facet = std::array<int, Dim>;

  template <template <int> class AnyMesh>
  explicit FaultSides(AnyMesh<Dim> const& mesh) : pairs_(mesh.splits)
  {
    if (!pairs_.haveCrossings()) {
      return;
    }
    const auto of_cells = facetsAtCrossings(mesh);
    for (auto const& name : mesh.faults) {
      for (auto const& facet : mesh.boundaries.at(name)) {
        findBeyond(facet, of_cells);
      }
    }
  }

  // The pair of this plus vertex, or nullptr.
  SplitVertex const* find(int plus) const { return pairs_.find(plus); }

  // The facet of the cell on the plus side. At a tip both sides share the vertex minus.
  Facet plusSide(Facet const& facet) const { return side(facet, beyondOf(facet), true); }

  // The facet of the cell on the minus side. It keeps the orientation of the plus side: for the
  // cell on the minus side it is inward.
  Facet minusSide(Facet const& facet) const { return side(facet, beyondOf(facet), false); }

private:
  // Plus vertices of a facet at crossings where it lies on the plus side of the other fault.
  using Beyond = std::vector<int>;

  static Facet sorted(Facet facet)
  {
    std::sort(facet.begin(), facet.end());
    return facet;
  }

  // The facets of cells, sorted, that have a vertex at a crossing.
  template <template <int> class AnyMesh>
  static std::set<Facet> facetsAtCrossings(AnyMesh<Dim> const& mesh)
  {
    std::unordered_set<int> copies;
    for (auto const& [mean, plus, both] : crossingsOf(mesh.splits)) {
      copies.insert({mean, plus[0], plus[1], both});
    }
    std::set<Facet> facets;
    for (auto const& cell : mesh.cells) {
      for (std::size_t left_out = 0; left_out < cell.size(); ++left_out) {
        Facet facet;
        for (std::size_t i = 0, k = 0; i < cell.size(); ++i) {
          if (i != left_out) {
            facet[k++] = cell[i];
          }
        }
        if (std::any_of(facet.begin(), facet.end(), [&](int v) { return copies.count(v) > 0; })) {
          facets.insert(sorted(facet));
        }
      }
    }
    return facets;
  }

  void findBeyond(Facet const& facet, std::set<Facet> const& of_cells)
  {
    std::vector<int> at_crossings;
    std::copy_if(facet.begin(), facet.end(), std::back_inserter(at_crossings),
                 [this](int vertex) { return pairs_.findCrossing(vertex) != nullptr; });
    for (unsigned choice = 1; choice < 1u << at_crossings.size(); ++choice) {
      Beyond beyond;
      for (std::size_t i = 0; i < at_crossings.size(); ++i) {
        if ((choice >> i & 1u) != 0) {
          beyond.push_back(at_crossings[i]);
        }
      }
      if (of_cells.count(sorted(side(facet, beyond, true))) > 0) {
        beyond_[sorted(facet)] = beyond;
      }
    }
  }

  Beyond const& beyondOf(Facet const& facet) const
  {
    static const Beyond none;
    if (beyond_.empty()) {
      return none;
    }
    const auto found = beyond_.find(sorted(facet));
    return found == beyond_.end() ? none : found->second;
  }

  Facet side(Facet const& facet, Beyond const& beyond, bool is_plus) const
  {
    Facet result;
    std::transform(facet.begin(), facet.end(), result.begin(), [&](int vertex) {
      const bool is_beyond = std::find(beyond.begin(), beyond.end(), vertex) != beyond.end();
      if (auto const* of = is_beyond ? pairs_.findCrossing(vertex) : nullptr) {
        return is_plus ? of->crossing.both : of->other();
      }
      auto const* pair = find(vertex);
      return pair && (pair->is_tip || !is_plus) ? pair->minus : vertex;
    });
    return result;
  }

  FaultPairs pairs_;
  std::map<Facet, Beyond> beyond_; // by sorted facet; of those that lie beyond another fault
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
