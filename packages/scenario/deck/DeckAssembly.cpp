#include "scenario/deck/DeckAssembly.hpp"

#include "parameters/ParameterValue.hpp"
#include "parameters/fields/VertexDataset.hpp"
#include "scenario/deck/Names.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace asperity::scenario
{
namespace
{
// The file that a deck names is looked for beside the deck, and then in the folder in which the
// program was started. If it is found, its name becomes absolute, so that the run's parameters.xml
// can be read from anywhere.
std::string besideDeck(std::string const& name, std::filesystem::path const& folder)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  for (auto const& place : {folder / name, fs::path(name)}) {
    if (!name.empty() && fs::exists(place, ignored)) {
      return fs::absolute(place).lexically_normal().string();
    }
  }
  return name;
}

void findFilesBesideDeck(ParameterList& list, std::filesystem::path const& folder)
{
  for (auto const& name : namesIn(list)) {
    if (list.isSublist(name)) {
      findFilesBesideDeck(list.sublist(name), folder);
    } else if (list.isType<std::string>(name)) {
      const auto text = list.get<std::string>(name);
      if (name == "File Name") {
        list.set(name, besideDeck(text, folder));
      } else if (VertexDataset::isName(text)) {
        const auto colon = text.find(":/");
        list.set(name, besideDeck(text.substr(0, colon), folder) + text.substr(colon));
      }
    }
  }
}

std::vector<std::string> namesOf(ParameterList const& deck)
{
  return deck.isSublist(names_list) ? namesIn(deck.sublist(names_list))
                                    : std::vector<std::string>();
}
} // namespace

GivenDeck deckAsGiven(CommandLine const& command_line, ParameterList const& valid)
{
  GivenDeck deck{readDeck(command_line.deck), {}};
  findFilesBesideDeck(*deck.list, std::filesystem::path(command_line.deck).parent_path());
  for (auto const& overlay : command_line.overlays) {
    overlayDeck(*deck.list, overlay);
  }
  for (auto const& path : command_line.removals) {
    removeEntry(*deck.list, path);
  }
  auto const before = namesOf(*deck.list);
  for (auto const& assignment : command_line.overrides) {
    applyOverride(*deck.list, valid, assignment);
  }
  findFilesBesideDeck(*deck.list, ""); // what overlays and overrides name
  for (auto const& name : namesOf(*deck.list)) {
    if (std::find(before.begin(), before.end(), name) == before.end()) {
      deck.names_to_use.push_back(name);
    }
  }
  return deck;
}

void assembleDeck(GivenDeck const& deck, ParameterList const& valid)
{
  resolveNames(*deck.list, valid, deck.names_to_use);
  completeAndValidate(*deck.list, valid, "Asperity");
}
} // namespace asperity::scenario
