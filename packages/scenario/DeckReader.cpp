#include "scenario/DeckReader.hpp"

#include "base/fields/VertexDataset.hpp"
#include "base/parameters/ParameterValue.hpp"
#include "io/OutputSet.hpp"
#include "scenario/setup/BoundarySetup.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/FrictionSetup.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "scenario/setup/Names.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

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
RCP<const ParameterList> outputParameters()
{
  auto list = rcp(new ParameterList(*io::OutputSet::validParameters()));
  Declare(*list).integer("Checkpoint Every n Steps", 5000, Range::atLeast(1),
                         "A checkpoint is written after this number of accepted steps.");
  return list;
}

// A name of a file in a deck is looked for beside the deck first. What is not there counts from
// where the program was started. A name that leads to a file becomes absolute, so that the run's
// parameters.xml can be read from anywhere.
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
      .sublist("Time Stepping", timeParameters(),
               "This list selects the time scheme and how the sizes of steps are chosen.")
      .sublist("Coupling", dynamics::CouplingSettings::validParameters(),
               "This list controls the fixed-point iteration between rate and state within a step.")
      .sublist("TNNMG", solverParameters(),
               "This list controls TNNMG, the solver of the rate problems.")
      .sublist("Output", outputParameters(), "This list selects what the run writes to files.")
      .list();
  list->setName("Asperity");
  return list;
}

RCP<ParameterList> readCompleteDeck(CommandLine const& command_line)
{
  auto const valid = deckParameters();
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
    applyOverride(*deck, *valid, assignment);
  }
  findFilesBesideDeck(*deck, ""); // what overlays and overrides name
  resolveNames(*deck, *valid, addedTo(names, namesOf(*deck)));
  completeAndValidate(*deck, *valid, "Asperity");
  return deck;
}
} // namespace asperity::scenario
