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
Declare declareTable(ParameterTable const& table);

// The entry `name`, which chooses a law of the registry, and for every law its table and what
// more(law, declare) adds.
template <class Law, class More>
void declareChoice(Declare& declare, std::string const& name, DefaultOr<std::string> const& usual,
                   Registry<Law> const& laws, std::string const& meaning, More const& more)
{
  declare.choice(name, usual, laws.names(), meaning)
    .hint("Laws of your own need --plugin LIBRARY.");
  for (auto const& law : laws.names()) {
    auto entries = declareTable(laws.at(law).parameters);
    more(laws.at(law), entries);
    declare.entriesWith(name, law, entries.list());
  }
}

template <class Law>
void declareChoice(Declare& declare, std::string const& name, DefaultOr<std::string> const& usual,
                   Registry<Law> const& laws, std::string const& meaning)
{
  declareChoice(declare, name, usual, laws, meaning, [](Law const&, Declare&) {});
}
} // namespace asperity::scenario
