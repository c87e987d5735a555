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

  // The midpoint of a cell's edge between two local vertices.
  int midpoint(int cell, int a, int b) const;

  // The midpoint of the edge of a facet of the outer boundary.
  int midpointOfFacet(typename Mesh<Dim>::Facet const& facet, int a, int b) const;

private:
  struct CellPoint
  {
    int cell, point;
  };
  using Cells = std::vector<CellPoint>;

  Cells const* find(int a, int b) const;
  void askOwners(OwnedPart<Dim> const& coarse, FaultEdges<Dim> const& faults,
                 Communicator const& communicator);

  Mesh<Dim> const& part_;
  Points<Dim>& points_;
  std::map<Edge, Cells> cells_;
};
} // namespace asperity::refinement::detail
