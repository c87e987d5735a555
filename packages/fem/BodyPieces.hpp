#pragma once

#include "base/Types.hpp"
#include "fem/Warning.hpp"
#include "mesh/Mesh.hpp"

#include <vector>

namespace asperity::fem
{
// Whether a body hangs together. Cells do where they share a facet; so do the two sides of a fault.
template <int Dim>
struct BodyPieces
{
  GlobalOrdinal num_pieces = 0;
  // Vertices where cells meet that do not hang together by the facets around it, as in a bow tie
  // or along an edge that two pieces share: there the body has no area to carry stress.
  GlobalOrdinal num_pinched = 0;
  GlobalOrdinal first_pinched = -1; // the least global id of them
  Point<Dim> place{};               // of that one [m]
  // (num_owned) each vertex has the largest global id of its piece, a pinched one -1.
  std::vector<GlobalOrdinal> labels;

  // The smallest label above this one. Collective.
  GlobalOrdinal nextPiece(GlobalOrdinal above, Communicator const& communicator) const;
};

// The same on any number of ranks. Collective.
template <int Dim>
BodyPieces<Dim> bodyPieces(Mesh<Dim> const& mesh, RCP<const Communicator> const& communicator);

// None if the body is one piece. Collective.
template <int Dim>
std::vector<Warning> warnOfPieces(Mesh<Dim> const& mesh,
                                  RCP<const Communicator> const& communicator);
} // namespace asperity::fem
