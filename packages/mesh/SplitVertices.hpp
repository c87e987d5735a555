#pragma once

#include "mesh/Crossings.hpp"
#include "mesh/Joints.hpp"

#include <algorithm>
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
// plus side of the other fault, and their cells have other copies there. At a joint the same is so
// for the facets of the fault that goes on, on both sides of the branch. Which copies they are is
// looked up among the facets of cells.
template <int Dim>
class FaultSides
{
public:
  using Facet = std::array<int, Dim>;

  template <template <int> class AnyMesh>
  explicit FaultSides(AnyMesh<Dim> const& mesh) : pairs_(mesh.splits)
  {
    for (auto const& joint : jointsOf(mesh.splits)) {
      joint_of_minus_.emplace(joint.minus, joint);
    }
    if (!pairs_.haveCrossings() && joint_of_minus_.empty()) {
      return;
    }
    const auto of_cells = facetsAtChoices(mesh);
    for (auto const& name : mesh.faults) {
      for (auto const& facet : mesh.boundaries.at(name)) {
        choose(facet, of_cells);
      }
    }
  }

  // The pair of this plus vertex, or nullptr.
  SplitVertex const* find(int plus) const { return pairs_.find(plus); }

  // Whether another fault crosses that of this plus vertex there.
  bool isAtCrossing(int plus) const { return pairs_.findCrossing(plus) != nullptr; }

  // The facet of the cell on the plus side. At a tip both sides share the vertex minus.
  Facet plusSide(Facet const& facet) const { return side(facet, chosenFor(facet), true); }

  // The facet of the cell on the minus side. It keeps the orientation of the plus side: for the
  // cell on the minus side it is inward.
  Facet minusSide(Facet const& facet) const { return side(facet, chosenFor(facet), false); }

private:
  // Corners of a facet, by their places in a number's bits, at which its cell has the second copy.
  using Corners = unsigned;
  struct Chosen
  {
    Facet facet{}; // as given, whose corners the bits count
    Corners on_plus_side = 0, on_minus_side = 0;
  };

  // The copies that the cells on one side of a fault have at its plus vertex. A second one, or -1,
  // is that on the plus side of another fault, which crosses it or ends there.
  using CopiesOnSide = std::array<int, 2>;
  CopiesOnSide copiesOnSide(int vertex, bool is_plus) const
  {
    auto const* pair = find(vertex);
    if (auto const* of = pairs_.findCrossing(vertex)) {
      return is_plus ? CopiesOnSide{vertex, of->crossing.both}
                     : CopiesOnSide{pair->minus, of->other()};
    }
    const int copy = pair && (pair->is_tip || !is_plus) ? pair->minus : vertex;
    if (!pair || pair->is_tip || pair->is_joint) {
      return {copy, -1};
    }
    const auto joint = joint_of_minus_.find(copy);
    return {copy, joint == joint_of_minus_.end() ? -1 : joint->second.plus};
  }

  static Facet sorted(Facet facet)
  {
    std::sort(facet.begin(), facet.end());
    return facet;
  }

  // The facets of cells, sorted, that have a vertex at a crossing or a joint.
  template <template <int> class AnyMesh>
  std::set<Facet> facetsAtChoices(AnyMesh<Dim> const& mesh) const
  {
    std::unordered_set<int> copies;
    for (auto const& [mean, plus, both] : crossingsOf(mesh.splits)) {
      copies.insert({mean, plus[0], plus[1], both});
    }
    for (auto const& [minus, joint] : joint_of_minus_) {
      copies.insert({minus, joint.plus});
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

  void choose(Facet const& facet, std::set<Facet> const& of_cells)
  {
    Chosen chosen{facet};
    chosen.on_plus_side = cornersOnSide(facet, true, of_cells);
    chosen.on_minus_side = cornersOnSide(facet, false, of_cells);
    if (chosen.on_plus_side != 0 || chosen.on_minus_side != 0) {
      chosen_[sorted(facet)] = chosen;
    }
  }

  Corners cornersOnSide(Facet const& facet, bool is_plus, std::set<Facet> const& of_cells) const
  {
    Corners with_second = 0;
    for (std::size_t i = 0; i < facet.size(); ++i) {
      with_second |= copiesOnSide(facet[i], is_plus)[1] >= 0 ? 1u << i : 0u;
    }
    for (Corners corners = 1; corners < 1u << facet.size(); ++corners) {
      if ((corners & ~with_second) == 0 &&
          of_cells.count(sorted(withCopies(facet, corners, is_plus))) > 0) {
        return corners;
      }
    }
    return 0;
  }

  Facet withCopies(Facet facet, Corners second, bool is_plus) const
  {
    for (std::size_t i = 0; i < facet.size(); ++i) {
      facet[i] = copiesOnSide(facet[i], is_plus)[second >> i & 1u];
    }
    return facet;
  }

  Chosen const* chosenFor(Facet const& facet) const
  {
    if (chosen_.empty()) {
      return nullptr;
    }
    const auto found = chosen_.find(sorted(facet));
    return found == chosen_.end() ? nullptr : &found->second;
  }

  // The facet may have another order of its corners than the one that was chosen for.
  Facet side(Facet const& facet, Chosen const* chosen, bool is_plus) const
  {
    Corners second = 0;
    for (std::size_t i = 0; chosen != nullptr && i < facet.size(); ++i) {
      const auto corner =
        std::find(chosen->facet.begin(), chosen->facet.end(), facet[i]) - chosen->facet.begin();
      const Corners on_side = is_plus ? chosen->on_plus_side : chosen->on_minus_side;
      second |= (on_side >> corner & 1u) << i;
    }
    return withCopies(facet, second, is_plus);
  }

  FaultPairs pairs_;
  std::unordered_map<int, Joint> joint_of_minus_;
  std::map<Facet, Chosen> chosen_; // by sorted facet; of those whose cells have a second copy
};

// The kind of a pair as a number, for MPI, checksums and files: 1 for a tip, 2 for a joint, else 0.
template <class Pair>
int kindOf(Pair const& pair)
{
  return pair.is_tip ? 1 : pair.is_joint ? 2 : 0;
}

inline SplitVertex splitVertex(int plus, int minus, int kind)
{
  return {plus, minus, kind == 1, kind == 2};
}

// Pairs as rows of numbers: plus, minus, kind.
using SplitRow = std::array<int, 3>;

inline std::vector<SplitRow> asRows(std::vector<SplitVertex> const& splits)
{
  std::vector<SplitRow> rows;
  rows.reserve(splits.size());
  for (auto const& pair : splits) {
    rows.push_back({pair.plus, pair.minus, kindOf(pair)});
  }
  return rows;
}

inline std::vector<SplitVertex> fromRows(std::vector<SplitRow> const& rows)
{
  std::vector<SplitVertex> splits;
  splits.reserve(rows.size());
  for (auto const& [plus, minus, kind] : rows) {
    splits.push_back(splitVertex(plus, minus, kind));
  }
  return splits;
}
} // namespace asperity::mesh
