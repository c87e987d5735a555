#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/deck/CommandLine.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
struct GivenDeck
{
  RCP<ParameterList> list;
  std::vector<std::string> names_to_use; // entries of its list `Names` that an override has added
};

// The deck that the command line names, as the user gives it: overlays, removals and overrides are
// applied. Files that entries name, by their declaration (Declare::fileName) or as a dataset, are
// looked for beside the deck, too. Throws InputError if that fails.
GivenDeck deckAsGiven(CommandLine const& command_line, ParameterList const& valid);

// Replaces the deck's names by their values, checks and completes it by the declarations `valid`,
// and lets its fields call its tables. Throws InputError if that fails.
void assembleDeck(GivenDeck const& deck, ParameterList const& valid);
} // namespace asperity::scenario
