#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"
#include "base/program/CommandLine.hpp"

namespace asperity::scenario
{
// The deck that the command line names as the user gives it: its overlays, removals and overrides
// are applied, the files that it names are found beside it. Throws InputError if that fails.
RCP<ParameterList> deckAsGiven(CommandLine const& command_line, ParameterList const& valid);

// The same with the values of its names in their places, checked and completed by these
// declarations. Throws InputError if that fails.
RCP<ParameterList> assembleDeck(CommandLine const& command_line, ParameterList const& valid);
} // namespace asperity::scenario
