#pragma once

#include "parameters/Parameters.hpp"

namespace asperity::scenario
{
// Throws InputError with the name of the parameter if a field of the completed deck of a mesh in
// the plane is an expression in z. Lists with Enabled = false, which no one reads, do not count.
void refuseZ(ParameterList const& deck);
} // namespace asperity::scenario
