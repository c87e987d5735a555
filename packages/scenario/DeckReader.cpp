#include "scenario/DeckReader.hpp"

#include "io/OutputSet.hpp"
#include "scenario/setup/BoundarySetup.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/FrictionSetup.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <sstream>

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
} // namespace

RCP<const ParameterList> deckParameters()
{
  auto const list =
    Declare()
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
  for (auto const& overlay : command_line.overlays) {
    overlayDeck(*deck, overlay);
  }
  for (auto const& assignment : command_line.overrides) {
    applyOverride(*deck, *valid, assignment);
  }
  completeAndValidate(*deck, *valid, "Asperity");
  return deck;
}

namespace
{
// One line for each entry, with all digits. In the order of the lists, which matters for regions
// and boundary conditions.
void writeEntries(std::ostream& text, ParameterList const& list, std::string const& path)
{
  for (auto const& item : list) {
    auto const name = joinPath(path, item.first);
    Teuchos::ParameterEntry const& entry = item.second;
    if (entry.isList()) {
      writeEntries(text, Teuchos::getValue<ParameterList>(entry), name);
    } else if (entry.isType<double>()) {
      text << name << " = " << Teuchos::getValue<double>(entry) << '\n';
    } else {
      text << name << " = " << entry.getAny(false) << '\n';
    }
  }
}
} // namespace

std::string fingerprint(ParameterList const& deck)
{
  ParameterList relevant(deck);
  relevant.remove("Output");
  relevant.remove("TNNMG");
  relevant.sublist("Time Stepping").remove("Final Time");
  std::ostringstream text;
  text.precision(17);
  writeEntries(text, relevant, "Asperity");
  return text.str();
}
} // namespace asperity::scenario
