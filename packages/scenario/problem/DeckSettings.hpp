#pragma once

#include "parameters/Parameters.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <optional>
#include <vector>

namespace asperity::scenario
{
// Lists of a complete deck of which the settings below hold only some entries. The others are
// fields, which can be evaluated only on a mesh, and the parameters of what the deck chooses by
// name: a type of mesh, laws of rock and friction, processes on faults.
struct DeckLists
{
  ParameterList mesh, bulk, friction, initial;
};

// All that a problem takes from its deck, read once. Whatever needs a part of it takes that part
// as an argument.
struct DeckSettings
{
  TimeSettings time;
  std::vector<BoundaryCondition> conditions; // in the order of the deck
  BulkSettings bulk;
  FrictionSettings friction;
  InitialSettings initial;
  SolverSettings solver;
  std::optional<std::vector<double>> up; // `Output / Up`, if the deck gives it
  DeckLists lists;

  // `deck` must be complete. Throws InputError where entries of a list contradict each other.
  static DeckSettings from(ParameterList const& deck);
};
} // namespace asperity::scenario
