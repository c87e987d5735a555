#pragma once

#include "Report.hpp"
#include "base/Types.hpp"
#include "parameters/Parameters.hpp"

namespace asperity::bench
{
// How slip stresses the fault of a deck on its mesh. In the plane (FaultStiffness) the table has
// the errors of waves of 12, 24, 48, ... cells that fit between the fault's ends, and the file, for
// numpy.loadtxt, a row for each node: its position, its weight, its row of the traction and, if
// there is one, that of the compression. In space (PlaneStiffness) both have a row for each number
// of cells in a wave.
Report measureStiffness(ParameterList const& deck, RCP<const Communicator> const& communicator);
} // namespace asperity::bench
