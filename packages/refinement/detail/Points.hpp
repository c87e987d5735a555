#pragma once

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "refinement/detail/FaultEdges.hpp"
#include "refinement/detail/PartEdges.hpp"
#include "refinement/detail/RefinementStep.hpp"

namespace asperity::refinement::detail
{
// What may become a vertex of the refined part, by numbers: the vertices of the coarse part, the
// midpoints of its edges, and midpoints of edges that only other ranks have.
//
// Global ids: coarse vertices keep theirs. Midpoints follow them in the order of the global ids of
// their edges' ends, the smaller one first. So ids do not depend on the ranks.
//
// Owners: a midpoint belongs to the owner of one of the two ends, which a hash of their ids chooses
// with equal probability. That rank has all cells around the midpoint. All copies of a vertex at a
// fault have one owner, and so have those of a midpoint.
template <int Dim>
class Points
{
public:
  // Collective.
  Points(OwnedPart<Dim> const& coarse, PartEdges<Dim> const& edges,
         Communicator const& communicator);

  int size() const { return static_cast<int>(ids_.size()); }
  int midpoint(int a, int b) const
  {
    const int edge = edges_.find(a, b);
    ASPERITY_ASSERT(edge >= 0);
    return num_coarse_ + edge;
  }
  GlobalOrdinal id(int point) const { return ids_[static_cast<std::size_t>(point)]; }
  int owner(int point) const { return owners_[static_cast<std::size_t>(point)]; }
  bool isMidpoint(int point) const { return point >= num_coarse_; }
  GlobalOrdinal numGlobal() const { return num_global_; }

  // The vertices between which the point lies; twice the same for a coarse vertex.
  Edge parents(int point) const { return parents_[static_cast<std::size_t>(point)]; }
  Point<Dim> coordinates(int point) const;

  // A point of another rank's edge, which lies where `twin` does. Returns its number.
  int add(GlobalOrdinal id, int twin);

private:
  void number(Communicator const& communicator);
  void chooseOwners();

  Mesh<Dim> const& part_;
  PartEdges<Dim> const& edges_;
  std::vector<int> const& coarse_owners_;
  int num_coarse_;
  GlobalOrdinal num_global_ = 0;
  std::vector<GlobalOrdinal> ids_;
  std::vector<int> owners_;
  std::vector<Edge> parents_;
};

// For every vertex the smallest global id of its copies at a fault, (num_local).
template <int Dim>
std::vector<GlobalOrdinal> idsOfPlaces(Mesh<Dim> const& part);

// The local vertex with this global id, or -1.
template <int Dim>
int localVertex(Mesh<Dim> const& part, GlobalOrdinal id)
{
  const auto begin = part.global_ids.begin(), end = part.global_ids.end();
  const auto ghosts = begin + part.num_owned;
  const auto owned = std::lower_bound(begin, ghosts, id);
  if (owned != ghosts && *owned == id) {
    return static_cast<int>(owned - begin);
  }
  const auto ghost = std::lower_bound(ghosts, end, id);
  return ghost != end && *ghost == id ? static_cast<int>(ghost - begin) : -1;
}
} // namespace asperity::refinement::detail
