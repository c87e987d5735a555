#pragma once

#include "BenchArguments.hpp"
#include "base/Types.hpp"

// Does what the arguments ask for: measures, prints a table on rank 0, writes JSON if the arguments
// name a file, and returns the exit status. Collective.
int measure(BenchArguments const& arguments,
            asperity::RCP<const asperity::Communicator> const& communicator);
