#pragma once

#include "mesh/Mesh.hpp"

namespace asperity::refinement::detail
{
// A rank's part, of which the owner of every vertex is known. The corners of its cells are in the
// order that RedRule wants, and may be negatively oriented.
template <int Dim>
struct OwnedPart
{
  Mesh<Dim> mesh;
  std::vector<int> owners; // (num_local), ranks
};

// Divides every cell once. Collective. InputError on every rank, which starts with `where`, if a
// fault asks for three copies of a vertex.
template <int Dim>
OwnedPart<Dim> refineOnce(OwnedPart<Dim> const& coarse, Communicator const& communicator,
                          std::string const& where);
} // namespace asperity::refinement::detail
