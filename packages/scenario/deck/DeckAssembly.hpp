#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"
#include "base/program/CommandLine.hpp"

namespace asperity::scenario
{
// The deck that the command line names, as the user gives it: overlays, removals and overrides are
// applied, and the files that it names are found. Throws InputError if that fails.
RCP<ParameterList> deckAsGiven(CommandLine const& command_line, ParameterList const& valid);

// The same deck in which names are replaced by their values, checked and completed by the
// declarations `valid`. Throws InputError if that fails.
RCP<ParameterList> assembleDeck(CommandLine const& command_line, ParameterList const& valid);
} // namespace asperity::scenario
