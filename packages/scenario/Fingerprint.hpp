#pragma once

#include "base/parameters/Parameters.hpp"
#include "io/checkpoint/Fingerprint.hpp"
#include "mesh/Mesh.hpp"

namespace asperity::scenario
{
// What must not change between a run and its restart: everything in the deck but the output, the
// final time and how the rate problems are solved; of the mesh file and of datasets their content,
// whatever their names; and how the mesh is numbered over the ranks. The same on every rank.
// Collective.
template <int Dim>
io::Fingerprint fingerprint(ParameterList const& deck, Mesh<Dim> const& mesh,
                            Communicator const& communicator);
} // namespace asperity::scenario
