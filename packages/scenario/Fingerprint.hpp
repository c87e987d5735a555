#pragma once

#include "io/checkpoint/Fingerprint.hpp"
#include "mesh/Mesh.hpp"
#include "parameters/Parameters.hpp"

namespace asperity::scenario
{
// The input that must not change between a run and its restart: everything in the deck except the
// output, the solvers (`TNNMG`, `Coupling`), the final time, the smallest step, the entries of
// watches, and those of step controls that their kind says may change; the content of the mesh
// file, of datasets and of the files of tables, not their names; and the numbering of the mesh over
// the ranks. The same on every rank. Collective.
template <int Dim>
io::Fingerprint fingerprint(ParameterList const& deck, Mesh<Dim> const& mesh,
                            Communicator const& communicator);
} // namespace asperity::scenario
