#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"
#include "portability/Parameter.hpp"
#include "portability/Registry.hpp"

#include <string>
#include <vector>

// The laws that a deck chooses by name, whose parameters stand beside the choice.
namespace asperity::scenario
{
using ParameterTable = std::vector<Parameter>;

// A field for each row of the table.
RCP<const ParameterList> declareTable(ParameterTable const& table);

// The entry `name`, which chooses a law of the registry, and for every law its table.
template <class Law>
void declareChoice(Declare& declare, std::string const& name, std::string const& usual,
                   Registry<Law> const& laws, std::string const& meaning)
{
  declare.choice(name, usual, laws.names(), meaning)
    .hint("Laws of your own need --plugin LIBRARY.");
  for (auto const& law : laws.names()) {
    declare.entriesWith(name, law, declareTable(laws.at(law).parameters));
  }
}
} // namespace asperity::scenario
