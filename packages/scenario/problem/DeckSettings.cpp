#include "scenario/problem/DeckSettings.hpp"

#include "io/OutputSet.hpp"
#include "scenario/setup/DeckDirections.hpp"

#include <utility>

namespace asperity::scenario
{
DeckSettings DeckSettings::from(ParameterList const& deck)
{
  DeckLists lists{deck.sublist("Bulk"), deck.sublist("Friction"), deck.sublist("Initial State")};
  auto time = TimeSettings::from(deck.sublist("Time Stepping"));
  auto const coupling = dynamics::CouplingSettings::from(deck.sublist("Coupling"), time.tolerance);
  auto const& output = deck.sublist("Output");
  return {std::move(time),
          coupling,
          MeshSettings::from(deck.sublist("Mesh")),
          readConditions(deck.sublist("Boundary Conditions")),
          BulkSettings::from(lists.bulk),
          FrictionSettings::from(lists.friction),
          InitialSettings::from(lists.initial),
          SolverSettings::from(deck.sublist("TNNMG")),
          givenUp(output),
          catalogue::DirectionEast::from(output),
          io::OutputSet::times(output),
          CheckpointIntervals::from(output),
          lists};
}
} // namespace asperity::scenario
