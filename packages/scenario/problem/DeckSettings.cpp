#include "scenario/problem/DeckSettings.hpp"

#include "scenario/setup/conditions/BoundaryChecks.hpp"

namespace asperity::scenario
{
DeckSettings DeckSettings::from(ParameterList const& deck)
{
  DeckSettings settings;
  settings.time = TimeSettings::from(deck.sublist("Time Stepping"));
  settings.conditions = readConditions(deck.sublist("Boundary Conditions"));
  settings.bulk = BulkSettings::from(deck.sublist("Bulk"));
  settings.friction = FrictionSettings::from(deck.sublist("Friction"));
  return settings;
}
} // namespace asperity::scenario
