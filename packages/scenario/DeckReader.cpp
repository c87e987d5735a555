#include "scenario/DeckReader.hpp"

#include "base/NearestName.hpp"
#include "friction/Registry.hpp"
#include "io/OutputSet.hpp"
#include "scenario/setup/BoundarySetup.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/FrictionSetup.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <algorithm>
#include <sstream>

namespace asperity::scenario
{
namespace
{
RCP<const ParameterList> outputParameters()
{
  auto list = rcp(new ParameterList(*io::OutputSet::validParameters()));
  Declare(*list).integer("Checkpoint Every n Steps", 5000, Range::atLeast(1),
                         "Accepted steps between two checkpoints.");
  return list;
}

// The law a deck names, or the default; an unknown name is refused here, since the valid parameters
// depend on it.
std::string lawOf(ParameterList const& deck, std::string const& name, std::string const& standard,
                  std::vector<std::string> const& known)
{
  if (!deck.isSublist("Friction") || !deck.sublist("Friction").isType<std::string>(name)) {
    return standard;
  }
  auto const law = deck.sublist("Friction").get<std::string>(name);
  ASPERITY_REQUIRE(std::find(known.begin(), known.end(), law) != known.end(),
                   "Asperity / Friction / " << name << " = '" << law << "' is unknown."
                                            << didYouMean(law, known));
  return law;
}

RCP<const ParameterList> parametersFor(ParameterList const& deck)
{
  return deckParameters(lawOf(deck, "Law", "Regularised", friction::frictionLawNames()),
                        lawOf(deck, "State Evolution", "Ageing", friction::stateLawNames()));
}
} // namespace

RCP<const ParameterList> deckParameters(std::string const& law, std::string const& state_law)
{
  auto const list =
    Declare()
      .sublist("Mesh", meshParameters(), "Where the body is.")
      .sublist("Bulk", bulkParameters(), "What the body is made of.")
      .sublist("Friction", frictionParameters(law, state_law), "What happens on the fault.")
      .openSublist("Boundary Conditions", boundaryParameters(),
                   "One list of any name for each condition.")
      .sublist("Initial State", initialStateParameters(), "How the run starts.")
      .sublist("Time Stepping", timeParameters(), "How it goes on.")
      .sublist("Coupling", dynamics::CouplingSettings::validParameters(),
               "The fixed point of rate and state.")
      .sublist("TNNMG", solverParameters(), "The solver of the rate problems.")
      .sublist("Output", outputParameters(), "What the run leaves.")
      .list();
  list->setName("Asperity");
  return list;
}

RCP<ParameterList> readCompleteDeck(CommandLine const& command_line)
{
  auto deck = readDeck(command_line.deck);
  for (auto const& overlay : command_line.overlays) {
    overlayDeck(*deck, overlay);
  }
  for (auto const& assignment : command_line.overrides) {
    applyOverride(*deck, *parametersFor(*deck), assignment);
  }
  completeAndValidate(*deck, *parametersFor(*deck), "Asperity");
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
