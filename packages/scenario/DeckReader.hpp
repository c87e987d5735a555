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

// What is added to the message by which a deck is refused: a line with the parameters of the deck,
// as the user wrote it, that have a finite number beyond 1e100, or nothing if there are none.
// Such a number is rarely meant, and what it spoils is often another quantity than the parameter.
// Left out are those that the message names already. Throws nothing.
std::string remarkOnLargeValues(CommandLine const& command_line, std::string const& message);
} // namespace asperity::scenario
