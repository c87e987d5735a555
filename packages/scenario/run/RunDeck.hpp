#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/checks/Description.hpp"
#include "scenario/deck/CommandLine.hpp"

namespace asperity::scenario
{
// Both functions throw InputError, on every rank, if the deck describes no problem that can be
// solved. `deck` must be complete; where it leaves out which way is up, they set that in it, as the
// mesh says. Collective.

// Prepares the run of a deck without touching a file, and returns the first lines of its log.
Description validateDeck(RCP<ParameterList> const& deck, CommandLine const& command_line,
                         RCP<const Communicator> const& communicator);

// Runs the deck, or goes on with a restart; returns the exit status. Throws as Simulation::run.
int runDeck(RCP<ParameterList> const& deck, CommandLine const& command_line,
            RCP<const Communicator> const& communicator);
} // namespace asperity::scenario
