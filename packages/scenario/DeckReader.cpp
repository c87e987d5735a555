#include "scenario/DeckReader.hpp"

#include "scenario/DeckDefaults.hpp"
#include "scenario/DeckParameters.hpp"
#include "scenario/deck/DeckAssembly.hpp"

namespace asperity::scenario
{
RCP<ParameterList> readCompleteDeck(CommandLine const& command_line)
{
  auto const valid = deckParameters();
  auto const given = deckAsGiven(command_line, *valid);
  chooseDefaults(*given.list);
  assembleDeck(given, *valid);
  return given.list;
}
} // namespace asperity::scenario
