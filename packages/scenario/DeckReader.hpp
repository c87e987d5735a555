#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"
#include "base/program/CommandLine.hpp"

#include <string>

namespace asperity::scenario
{
// All parameters of a deck, including those of every registered plugin.
RCP<const ParameterList> deckParameters();

// Reads the deck that the command line names, finds the files that it names beside it, applies its
// overlays and overrides, checks and completes it. Throws InputError if that fails.
RCP<ParameterList> readCompleteDeck(CommandLine const& command_line);
} // namespace asperity::scenario
