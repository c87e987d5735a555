#pragma once

#include "base/Types.hpp"
#include "parameters/Entries.hpp"
#include "registry/Parameter.hpp"
#include "registry/Registry.hpp"

#include <string>
#include <vector>

// The laws that a deck chooses by name, whose parameters are entries of the same list.
namespace asperity::scenario
{
using ParameterTable = std::vector<Parameter>;

// A field for each row of the table.
Declare declareTable(ParameterTable const& table);

namespace detail
{
template <class Law, class More>
void addTables(Declare& declare, std::string const& choice, Registry<Law> const& laws,
               More const& more)
{
  declare.hint("Laws of your own need --plugin LIBRARY.");
  for (auto const& law : laws.names()) {
    auto entries = declareTable(laws.at(law).parameters);
    more(laws.at(law), entries);
    declare.entriesWith(choice, law, entries.list());
  }
}
} // namespace detail

// Adds the entry `name`, which chooses a law of the registry, and for every law its table and what
// more(law, declare) adds. The member is the name of the law; `required` before the registry says
// that the deck has to give it.
template <class Settings, class Member, class Law, class More>
void addLaws(Entries<Settings>& entries, std::string const& name, Member member,
             Registry<Law> const& laws, std::string const& meaning, More const& more)
{
  entries.choiceOfWords(name, member, laws.names(), meaning);
  detail::addTables(entries.others(), name, laws, more);
}
template <class Settings, class Member, class Law>
void addLaws(Entries<Settings>& entries, std::string const& name, Member member,
             Registry<Law> const& laws, std::string const& meaning)
{
  addLaws(entries, name, member, laws, meaning, [](Law const&, Declare&) {});
}
template <class Settings, class Member, class Law>
void addLaws(Entries<Settings>& entries, std::string const& name, Member member, Required,
             Registry<Law> const& laws, std::string const& meaning)
{
  entries.choiceOfWords(name, member, required, laws.names(), meaning);
  detail::addTables(entries.others(), name, laws, [](Law const&, Declare&) {});
}
} // namespace asperity::scenario
