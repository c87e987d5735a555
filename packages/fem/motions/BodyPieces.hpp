#pragma once

#include "base/Types.hpp"
#include "base/Warning.hpp"
#include "mesh/Mesh.hpp"

#include <vector>

namespace asperity::fem
{
// The connected pieces of a body. Cells are connected where they share a facet, and so are the two
// sides of a fault.
template <int Dim>
struct BodyPieces
{
  GlobalOrdinal num_pieces = 0;
  // Pinched vertices: the cells around one are not all connected by the facets that contain it, as
  // in a bow tie or along an edge that two pieces share. There the body has no area to carry
  // stress.
  GlobalOrdinal num_pinched = 0;
  GlobalOrdinal first_pinched = -1; // the smallest global id of a pinched vertex
  Point<Dim> place{};               // of that vertex [m]
  // (num_owned) the largest global id in the vertex's piece; -1 for a pinched vertex.
  std::vector<GlobalOrdinal> labels;

  // The smallest label above this one. Collective.
  GlobalOrdinal nextPiece(GlobalOrdinal above, Communicator const& communicator) const;
};

// The result does not depend on the number of ranks. Collective.
template <int Dim>
BodyPieces<Dim> bodyPieces(Mesh<Dim> const& mesh, RCP<const Communicator> const& communicator);

// Warnings of further pieces and of pinched vertices; none if the body is one piece. Collective.
template <int Dim>
std::vector<Warning> warnOfPieces(Mesh<Dim> const& mesh,
                                  RCP<const Communicator> const& communicator);
} // namespace asperity::fem
