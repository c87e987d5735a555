#pragma once

#include "base/parameters/Parameters.hpp"
#include "io/checkpoint/Fingerprint.hpp"
#include "mesh/Mesh.hpp"

namespace asperity::scenario
{
// The input that must not change between a run and its restart: everything in the deck but the
// output, the solvers (`TNNMG`, `Coupling`), the final time, the smallest step, the tolerance of
// steps and the limits of forced ones; the content, but not the
// names, of the mesh file and of datasets; and the numbering of the mesh over the ranks. The same
// on every rank. Collective.
template <int Dim>
io::Fingerprint fingerprint(ParameterList const& deck, Mesh<Dim> const& mesh,
                            Communicator const& communicator);
} // namespace asperity::scenario
