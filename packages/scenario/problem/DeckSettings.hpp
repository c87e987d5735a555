#pragma once

#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"

namespace asperity::scenario
{
// What a complete deck says about rock and friction, but for its fields; read once.
struct DeckSettings
{
  BulkSettings bulk;
  FrictionSettings friction;

  static DeckSettings from(ParameterList const& deck)
  {
    return {BulkSettings::from(deck.sublist("Bulk")),
            FrictionSettings::from(deck.sublist("Friction"))};
  }
};
} // namespace asperity::scenario
