#pragma once

#include "Report.hpp"
#include "base/Types.hpp"
#include "parameters/Parameters.hpp"

namespace asperity::bench
{
// Times the kernels of a step on the matrices and the fault of a deck, each together with the bytes
// that it has to move at least: products with K, sweep, transfers and V-cycle of multigrid, the
// block problems of friction and the update of its state. A STREAM triad in the same run says how
// fast the memory is. `deck` must be complete. Collective; the report is for all ranks together.
Report measureKernels(ParameterList const& deck, RCP<const Communicator> const& communicator);
} // namespace asperity::bench
