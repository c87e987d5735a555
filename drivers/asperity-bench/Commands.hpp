#pragma once

#include "BenchArguments.hpp"
#include "base/Types.hpp"

// Each command measures, prints a table on rank 0, writes JSON if the arguments name a file, and
// returns the exit status. Collective.
int measureScaling(BenchArguments const& arguments,
                   asperity::RCP<const asperity::Communicator> const& communicator);
int measureStretch(BenchArguments const& arguments,
                   asperity::RCP<const asperity::Communicator> const& communicator);
