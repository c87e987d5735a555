#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"

#include <string>

// Makes the mesh of a completed deck and describes it: the numbers of cells and vertices, their
// largest number on a rank over the mean, and the peak memory of all ranks together before and
// after, in total and per cell. The same text on every rank. Collective.
std::string meshCounts(Teuchos::ParameterList const& deck,
                       Teuchos::RCP<const asperity::Communicator> const& communicator);
