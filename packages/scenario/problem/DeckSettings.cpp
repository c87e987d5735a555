#include "scenario/problem/DeckSettings.hpp"

#include "io/OutputSet.hpp"
#include "scenario/setup/DeckDirections.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <utility>

namespace asperity::scenario
{
DeckSettings DeckSettings::from(ParameterList const& deck)
{
  DeckLists lists{deck.sublist(deck_lists::bulk), deck.sublist(deck_lists::friction),
                  deck.sublist(deck_lists::initial)};
  auto time = TimeSettings::from(deck.sublist(deck_lists::time));
  auto const coupling =
    dynamics::CouplingSettings::from(deck.sublist(deck_lists::coupling), time.tolerance);
  auto const& output = deck.sublist(deck_lists::output);
  return {std::move(time),
          coupling,
          MeshSettings::from(deck.sublist(deck_lists::mesh)),
          readConditions(deck.sublist(deck_lists::conditions)),
          BulkSettings::from(lists.bulk),
          FrictionSettings::from(lists.friction),
          InitialSettings::from(lists.initial),
          SolverSettings::from(deck.sublist(deck_lists::solver)),
          givenUp(output),
          catalogue::DirectionEast::from(output),
          io::OutputSet::times(output),
          CheckpointIntervals::from(output),
          lists};
}
} // namespace asperity::scenario
