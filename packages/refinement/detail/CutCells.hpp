#pragma once

#include "refinement/detail/FaultEdges.hpp"
#include "refinement/detail/Points.hpp"

namespace asperity::refinement::detail
{
// Which cells have a midpoint other than that of their edge, because they lie on the plus side of
// an edge that a fault cuts open. A rank that owns no end of such an edge asks the owner.
template <int Dim>
class CutCells
{
public:
  // Adds points of other ranks to `points`. Collective.
  CutCells(OwnedPart<Dim> const& coarse, FaultEdges<Dim> const& faults, Points<Dim>& points,
           Communicator const& communicator);

  // The midpoint of the edge between two local vertices of a cell, or of a facet of the outer
  // boundary, which is that of the cell with all its vertices.
  template <std::size_t N>
  int midpoint(std::array<int, N> const& simplex, int a, int b) const
  {
    const auto found = cells_.find(mesh::detail::sorted(Edge{a, b}));
    if (found != cells_.end()) {
      for (auto const& [cell, point] : found->second) {
        if (hasVertices(part_.cells[cell], simplex)) {
          return point;
        }
      }
    }
    return points_.midpoint(a, b);
  }

private:
  struct CellPoint
  {
    int cell, point;
  };

  void queryOwners(OwnedPart<Dim> const& coarse, FaultEdges<Dim> const& faults,
                   Communicator const& communicator);

  Mesh<Dim> const& part_;
  Points<Dim>& points_;
  std::map<Edge, std::vector<CellPoint>> cells_;
};
} // namespace asperity::refinement::detail
