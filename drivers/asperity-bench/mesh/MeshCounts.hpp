#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"

#include <string>

// Makes the mesh of a completed deck, which is then forgotten, and says how many cells and vertices
// it has, how evenly the ranks have them (largest over mean), and the largest memory of the ranks
// together, before and after, in all and per cell. The same text on every rank. Collective.
std::string meshCounts(Teuchos::ParameterList const& deck,
                       Teuchos::RCP<const asperity::Communicator> const& communicator);
