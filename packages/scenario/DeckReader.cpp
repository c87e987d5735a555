#include "scenario/DeckReader.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "catalogue/stress/CoulombPlanes.hpp"
#include "io/OutputSet.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/UnreadEntries.hpp"
#include "parameters/fields/Expression.hpp"
#include "scenario/deck/DeckAssembly.hpp"
#include "scenario/deck/Names.hpp"
#include "scenario/problem/InitialState.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/CheckpointSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/conditions/BoundarySetup.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/friction/LawSetup.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace asperity::scenario
{
namespace
{
RCP<const ParameterList> outputParameters()
{
  auto list = rcp(new ParameterList(*io::OutputSet::validParameters()));
  Declare declare(*list);
  catalogue::declareCoulombPlanes(declare);
  CheckpointIntervals::declare(*list);
  return list;
}

// No quantity of an earthquake is larger than this in SI units.
constexpr double large = 1e100;
constexpr std::size_t most_named = 3;

// In a number, an array or an expression: "1e308", "{1, 1e308}", "x < 1e308 ? a : b".
bool hasLargeNumber(std::string const& text)
{
  auto const parts = formulaParts(text);
  return std::any_of(parts.begin(), parts.end(), [](auto const& part) {
    return part.is_number && readNumber(part.text).value_or(0) > large;
  });
}

void collect(ParameterList const& list, std::string const& path, std::string const& message,
             std::vector<std::string>& found)
{
  for (auto const& name : namesIn(list)) {
    auto const& entry = list.getEntry(name);
    auto const where = joinPath(path, name);
    if (entry.isList()) {
      collect(list.sublist(name), where, message, found);
    } else if (hasLargeNumber(plainText(entry)) && message.find(where) == std::string::npos) {
      found.push_back(where + " = " + excerpt(plainText(entry)));
    }
  }
}
} // namespace

RCP<const ParameterList> deckParameters()
{
  auto const list =
    Declare()
      .openSublist(names_list, nameParameters(), meaningOfNames())
      .sublist(
        "Mesh", meshParameters(),
        "This list says which region of space the body fills and how it is divided into cells.")
      .sublist("Bulk", bulkParameters(),
               "This list describes the material of the body and its gravity.")
      .sublist("Friction", frictionParameters(),
               "This list describes friction on the fault and the stress that the fault bears.")
      .openSublist("Boundary Conditions", boundaryParameters(),
                   "Each list in here, of any name, is one condition on one boundary.")
      .sublist("Initial State", initialStateParameters(),
               "This list describes the state in which the run starts.")
      .sublist("Time Stepping", timeParameters(), meaningOfTime())
      .sublist("Coupling", dynamics::CouplingSettings::validParameters(),
               "This list controls the fixed-point iteration between rate and state within a step.")
      .sublist("TNNMG", solverParameters(),
               "This list controls TNNMG, the solver of the rate problems.")
      .sublist("Output", outputParameters(), "This list selects what the run writes to files.")
      .list();
  list->setName("Asperity");
  return list;
}

namespace
{
// Entries that earlier versions had, and what takes their place.
void refuseFormerEntries(ParameterList const& deck)
{
  if (!deck.isSublist("Output")) {
    return;
  }
  for (std::string const name : {"Text Format", "SEAS", "SCEC"}) {
    ASPERITY_REQUIRE(!deck.sublist("Output").isParameter(name),
                     "Asperity / Output / "
                       << name
                       << " is no entry of a deck any more: runs write no files for SEAS and SCEC. "
                          "Take it out (--remove \"Output/"
                       << name
                       << "\"); `asperity-platform write DIR PROBLEM` writes the files of a "
                          "run that is done or goes on, and has options for what the list said.");
  }
}

// What no fault has need not be in the deck: the defaults of the laws follow from the faults.
void chooseLawsOf(ParameterList& deck)
{
  if (deck.isParameter("Friction") && !deck.isSublist("Friction")) {
    return; // an error that is told later
  }
  const bool is_wanted =
    deck.isSublist("Boundary Conditions") && haveFriction(deck.sublist("Boundary Conditions"));
  if (is_wanted && !deck.isParameter("Friction")) {
    return; // so is this
  }
  chooseLaws(deck.sublist("Friction"), is_wanted);
}
} // namespace

RCP<ParameterList> readCompleteDeck(CommandLine const& command_line)
{
  auto const valid = deckParameters();
  auto const given = deckAsGiven(command_line, *valid);
  auto const deck = given.list;
  const bool names_scheme =
    deck->isSublist("Time Stepping") && deck->sublist("Time Stepping").isParameter("Scheme");
  refuseFormerEntries(*deck);
  chooseLawsOf(*deck);
  assembleDeck(given, *valid);
  if (!names_scheme && BulkSettings::from(deck->sublist("Bulk")).isQuasiDynamic()) {
    deck->sublist("Time Stepping")
      .setEntry("Scheme", Teuchos::ParameterEntry(std::string(massless_scheme), true));
    completeAndValidate(*deck, *valid, "Asperity");
  }
  return deck;
}

namespace
{
void collectTexts(ParameterList const& list, std::string const& path,
                  std::map<std::string, std::string>& texts)
{
  for (auto const& name : namesIn(list)) {
    auto const where = joinPath(path, name);
    if (list.isSublist(name)) {
      collectTexts(list.sublist(name), where, texts);
    } else {
      texts[where] = plainText(list.getEntry(name));
    }
  }
}

std::map<std::string, std::string> textsOf(ParameterList const& list)
{
  std::map<std::string, std::string> texts;
  collectTexts(list, "", texts);
  return texts;
}

std::set<std::string> pathsOf(std::vector<UnreadEntry> const& entries)
{
  std::set<std::string> paths;
  for (auto const& entry : entries) {
    paths.insert(entry.path);
  }
  return paths;
}

// Takes out what has the same text in a deck `before` more was applied, `given`, unless it was
// unread there already.
void removeFormer(ParameterList const& before, ParameterList const& given,
                  std::set<std::string> const& unread_before, std::vector<UnreadEntry>& unread)
{
  auto const former = textsOf(before), texts = textsOf(given);
  const auto is_former = [&](UnreadEntry const& entry) {
    auto const text = former.find(entry.path), now = texts.find(entry.path);
    return text != former.end() && now != texts.end() && text->second == now->second &&
           unread_before.count(entry.path) == 0;
  };
  unread.erase(std::remove_if(unread.begin(), unread.end(), is_former), unread.end());
}

Warning warningOf(std::vector<UnreadEntry> const& unread)
{
  std::string text;
  for (std::size_t i = 0; i < unread.size() && i < most_named; ++i) {
    auto const& entry = unread[i];
    text += (i == 0 ? "" : " ") + entry.path + " has no effect: only " + entry.choice + " = " +
            entry.word + " reads it, but it is " + entry.taken + ".";
  }
  if (unread.size() > most_named) {
    text += " And " + std::to_string(unread.size() - most_named) + " more of them.";
  }
  return {"unread parameters", text + " Change the choice, or remove the entries."};
}
} // namespace

std::optional<Warning> warnOfUnreadEntries(CommandLine const& command_line,
                                           ParameterList const& complete)
{
  auto const valid = deckParameters();
  auto unread = unreadEntries(complete, *valid);
  if (unread.empty()) {
    return std::nullopt;
  }
  try {
    auto const given = deckAsGiven(command_line, *valid).list;
    auto const texts = textsOf(*given);
    unread.erase(std::remove_if(unread.begin(), unread.end(),
                                [&](auto const& entry) { return texts.count(entry.path) == 0; }),
                 unread.end()); // defaults
    CommandLine line = command_line;
    line.removals.clear();
    line.overrides.clear();
    line.overlays.clear();
    for (auto next = command_line.overlays.begin();; ++next) {
      auto const before = deckAsGiven(line, *valid).list;
      const bool has_warned = !command_line.restart.empty() && line.overlays.empty();
      removeFormer(*before, *given,
                   has_warned ? std::set<std::string>() : pathsOf(unreadEntries(*before, *valid)),
                   unread);
      if (next == command_line.overlays.end()) {
        break;
      }
      line.overlays.push_back(*next);
    }
  } catch (InputError const&) {
    return std::nullopt;
  }
  return unread.empty() ? std::nullopt : std::optional<Warning>(warningOf(unread));
}

std::string remarkOnLargeValues(CommandLine const& command_line, std::string const& message)
{
  std::vector<std::string> found;
  try {
    collect(*deckAsGiven(command_line, *deckParameters()).list, "", message, found);
  } catch (InputError const&) { // the deck cannot be read: `message` says so
    return "";
  }
  if (found.empty()) {
    return "";
  }
  std::string line = "\nThe deck has numbers beyond 1e100: " + found.front();
  for (std::size_t i = 1; i < found.size() && i < most_named; ++i) {
    line += ", " + found[i];
  }
  return line + (found.size() > most_named
                   ? " and " + std::to_string(found.size() - most_named) + " more."
                   : ".");
}
} // namespace asperity::scenario
