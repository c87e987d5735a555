#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"
#include "base/program/CommandLine.hpp"

namespace asperity::scenario
{
// Reads the deck that the command line names, finds the files that it names beside it, applies its
// overlays, removals and overrides, puts the values of its names in their places, and checks and
// completes it by these declarations. Throws InputError if that fails.
RCP<ParameterList> assembleDeck(CommandLine const& command_line, ParameterList const& valid);
} // namespace asperity::scenario
