#pragma once

#include "parameters/Parameters.hpp"

namespace asperity::scenario
{
// Sets the choices that a deck leaves out and whose default follows from other lists: no friction
// and no state where no fault has friction (chooseLaws), and the scheme of a quasi-dynamic body.
// They count as defaults. The deck is as the user gives it: neither complete nor checked. What is
// wrong with it is left as it is, for completeAndValidate to refuse.
void chooseDefaults(ParameterList& deck);
} // namespace asperity::scenario
