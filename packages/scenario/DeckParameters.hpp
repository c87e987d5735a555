#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"

namespace asperity::scenario
{
// All parameters of a deck, including those of every registered plugin.
RCP<const ParameterList> deckParameters();
} // namespace asperity::scenario
