#include "scenario/deck/DeckAssembly.hpp"

#include "parameters/Alternatives.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/fields/VertexDataset.hpp"
#include "scenario/deck/Names.hpp"
#include "scenario/deck/Tables.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace asperity::scenario
{
using Teuchos::ParameterEntry;

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

bool isOfKind(ParameterEntry const* declared, ParameterKind kind)
{
  auto const info = parameterInfo(*declared);
  return !info.is_null() && info->kind == kind;
}

// All declarations that an entry of the name may have: its own, and those that words of a choice
// bring (Declare::entriesWith), whichever of them the deck chooses in the end.
std::vector<ParameterEntry const*> declarationsOf(std::string const& name,
                                                  ParameterList const& valid)
{
  std::vector<ParameterEntry const*> found;
  if (auto const* own = valid.getEntryPtr(name)) {
    found.push_back(own);
  }
  for (auto const& item : valid) {
    if (isAlternative(item.second)) {
      if (auto const* brought = get<ParameterList>(item.second).getEntryPtr(name)) {
        found.push_back(brought);
      }
    }
  }
  return found;
}

void findFilesIn(ParameterList& list, ParameterList const& valid,
                 std::filesystem::path const& folder);

// A file name is known by its declaration, a dataset by its form wherever it stands.
void findFilesIn(ParameterEntry& entry, std::vector<ParameterEntry const*> const& declarations,
                 std::filesystem::path const& folder)
{
  const auto has = [&](ParameterKind kind) {
    return std::any_of(declarations.begin(), declarations.end(),
                       [kind](auto const* each) { return isOfKind(each, kind); });
  };
  if (entry.isList()) {
    const auto declared = std::find_if(declarations.begin(), declarations.end(),
                                       [](auto const* each) { return each->isList(); });
    auto& content = Teuchos::getValue<ParameterList>(entry);
    auto const valid =
      declared == declarations.end() ? ParameterList() : get<ParameterList>(**declared);
    if (has(ParameterKind::open_sublist)) {
      for (auto const& name : namesIn(content)) {
        findFilesIn(content.getEntry(name), {&valid.entry(valid.begin())}, folder);
      }
    } else {
      findFilesIn(content, valid, folder);
    }
  } else if (holds<std::string>(entry)) {
    const auto text = get<std::string>(entry);
    if (has(ParameterKind::file_name)) {
      replaceValue(entry, besideDeck(text, folder));
    } else if (VertexDataset::isName(text)) {
      const auto colon = text.find(":/");
      replaceValue(entry, besideDeck(text.substr(0, colon), folder) + text.substr(colon));
    }
  }
}

void findFilesIn(ParameterList& list, ParameterList const& valid,
                 std::filesystem::path const& folder)
{
  for (auto const& name : namesIn(list)) {
    findFilesIn(list.getEntry(name), declarationsOf(name, valid), folder);
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
  findFilesIn(*deck.list, valid, std::filesystem::path(command_line.deck).parent_path());
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
  findFilesIn(*deck.list, valid, ""); // what overlays and overrides name
  for (auto const& name : namesOf(*deck.list)) {
    if (std::find(before.begin(), before.end(), name) == before.end()) {
      deck.names_to_use.push_back(name);
    }
  }
  return deck;
}

void assembleDeck(GivenDeck const& deck, ParameterList const& valid)
{
  auto const tables = resolveNames(*deck.list, valid, deck.names_to_use);
  completeAndValidate(*deck.list, valid, "Asperity");
  giveTables(*deck.list, tables);
}
} // namespace asperity::scenario
