#pragma once

#include "Report.hpp"
#include "base/Types.hpp"
#include "parameters/Parameters.hpp"

namespace asperity::bench
{
// Makes the first accepted steps of a deck, without outputs. `deck` must be complete. The table has
// what a coupled step costs; the file has the counts of all of them, in JSON. Collective; the
// report is that of this rank.
Report measureSteps(ParameterList const& deck, int num_steps,
                    RCP<const Communicator> const& communicator);
} // namespace asperity::bench
