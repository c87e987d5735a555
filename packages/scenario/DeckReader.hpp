#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/deck/CommandLine.hpp"

namespace asperity::scenario
{
// Reads the deck that the command line names, finds the files that it names beside it, applies its
// overlays and overrides, checks and completes it. Throws InputError if that fails.
RCP<ParameterList> readCompleteDeck(CommandLine const& command_line);
} // namespace asperity::scenario
