#include "scenario/deck/DeckAssembly.hpp"

#include "base/fields/VertexDataset.hpp"
#include "base/parameters/ParameterValue.hpp"
#include "scenario/deck/Names.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
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
  std::vector<std::string> names;
  for (auto const& item : list) {
    names.push_back(item.first);
  }
  for (auto const& name : names) {
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
  auto names =
    deck.isSublist(names_list) ? namesIn(deck.sublist(names_list)) : std::vector<std::string>();
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> addedTo(std::vector<std::string> const& before,
                                 std::vector<std::string> const& after)
{
  std::vector<std::string> added;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::back_inserter(added));
  return added;
}

// The deck as given, and the names in its list `Names` that overrides have added.
RCP<ParameterList> readGiven(CommandLine const& command_line, ParameterList const& valid,
                             std::vector<std::string>& added)
{
  auto deck = readDeck(command_line.deck);
  findFilesBesideDeck(*deck, std::filesystem::path(command_line.deck).parent_path());
  for (auto const& overlay : command_line.overlays) {
    overlayDeck(*deck, overlay);
  }
  for (auto const& path : command_line.removals) {
    removeEntry(*deck, path);
  }
  auto const names = namesOf(*deck);
  for (auto const& assignment : command_line.overrides) {
    applyOverride(*deck, valid, assignment);
  }
  findFilesBesideDeck(*deck, ""); // what overlays and overrides name
  added = addedTo(names, namesOf(*deck));
  return deck;
}
} // namespace

RCP<ParameterList> deckAsGiven(CommandLine const& command_line, ParameterList const& valid)
{
  std::vector<std::string> added;
  return readGiven(command_line, valid, added);
}

RCP<ParameterList> assembleDeck(CommandLine const& command_line, ParameterList const& valid)
{
  std::vector<std::string> added;
  auto deck = readGiven(command_line, valid, added);
  resolveNames(*deck, valid, added);
  completeAndValidate(*deck, valid, "Asperity");
  return deck;
}
} // namespace asperity::scenario
