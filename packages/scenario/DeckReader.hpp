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

// What must not change between a run and its restart: everything but the output, the final time
// and how the rate problems are solved.
std::string fingerprint(ParameterList const& deck);
} // namespace asperity::scenario
