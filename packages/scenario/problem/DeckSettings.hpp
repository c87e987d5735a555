#pragma once

#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"

#include <vector>

namespace asperity::scenario
{
// What a complete deck says about time, conditions, rock and friction, but for its fields. It is
// read here, once for a problem; whatever needs a part of it takes that part as an argument.
struct DeckSettings
{
  TimeSettings time;
  std::vector<BoundaryCondition> conditions; // in the order of the deck
  BulkSettings bulk;
  FrictionSettings friction;

  static DeckSettings from(ParameterList const& deck);
};
} // namespace asperity::scenario
