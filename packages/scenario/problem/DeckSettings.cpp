#include "scenario/problem/DeckSettings.hpp"

#include "scenario/setup/DeckDirections.hpp"

namespace asperity::scenario
{
DeckSettings DeckSettings::from(ParameterList const& deck)
{
  DeckLists lists{deck.sublist("Mesh"), deck.sublist("Bulk"), deck.sublist("Friction"),
                  deck.sublist("Initial State")};
  return {TimeSettings::from(deck.sublist("Time Stepping")),
          readConditions(deck.sublist("Boundary Conditions")),
          BulkSettings::from(lists.bulk),
          FrictionSettings::from(lists.friction),
          InitialSettings::from(lists.initial),
          SolverSettings::from(deck.sublist("TNNMG")),
          givenUp(deck.sublist("Output")),
          lists};
}
} // namespace asperity::scenario
