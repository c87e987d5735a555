#pragma once

#include "catalogue/stress/CoulombPlanes.hpp"
#include "dynamics/coupling/CouplingSettings.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/CheckpointSetup.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/mesh/MeshSettings.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <optional>
#include <vector>

namespace asperity::scenario
{
// Lists of a complete deck of which the settings below hold only some entries. The others are
// fields, which can be evaluated only on a mesh, and the parameters of what the deck chooses by
// name: laws of rock and friction, processes on faults.
struct DeckLists
{
  ParameterList bulk, friction, initial;
};

// All that a problem and the steps of its run take from their deck, read once. Whatever needs a
// part of it takes that part as an argument.
struct DeckSettings
{
  TimeSettings time;
  dynamics::CouplingSettings coupling;
  MeshSettings mesh;
  std::vector<BoundaryCondition> conditions; // in the order of the deck
  BulkSettings bulk;
  FrictionSettings friction;
  InitialSettings initial;
  SolverSettings solver;
  // Of the list `Output`:
  std::optional<std::vector<double>> up; // `Up`, if the deck gives it
  catalogue::DirectionEast east;
  std::vector<double> output_times; // [s] in no order
  CheckpointIntervals checkpoints;
  DeckLists lists;

  // `deck` must be complete. Throws InputError where entries of a list contradict each other.
  static DeckSettings from(ParameterList const& deck);
};
} // namespace asperity::scenario
