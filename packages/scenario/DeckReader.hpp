#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"
#include "base/program/CommandLine.hpp"

#include <string>

namespace asperity::scenario
{
// All parameters of a deck, those of every registered plugin among them.
RCP<const ParameterList> deckParameters();

// The deck of a command line: read, overlaid, overridden, checked and completed. InputError
// otherwise.
RCP<ParameterList> readCompleteDeck(CommandLine const& command_line);
} // namespace asperity::scenario
