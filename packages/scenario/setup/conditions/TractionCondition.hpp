#pragma once

#include "scenario/setup/conditions/ConditionTypes.hpp"

namespace asperity::scenario
{
inline constexpr char const* traction_type = "Prescribed Traction";

// The Type 'Prescribed Traction': its name, its entries, which boundaryParameters() declares, and
// the function that makes it.
ConditionType tractionType();
void declareTraction(Declare& declare);
} // namespace asperity::scenario
