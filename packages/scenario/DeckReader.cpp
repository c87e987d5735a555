#include "scenario/DeckReader.hpp"

#include "io/OutputSet.hpp"
#include "scenario/deck/DeckAssembly.hpp"
#include "scenario/deck/Names.hpp"
#include "scenario/setup/BoundarySetup.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/FrictionSetup.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

namespace asperity::scenario
{
namespace
{
RCP<const ParameterList> outputParameters()
{
  auto list = rcp(new ParameterList(*io::OutputSet::validParameters()));
  Declare(*list)
    .integer("Checkpoint Every n Steps", 5000, Range::atLeast(1),
             "A checkpoint is written after this number of accepted steps.")
    .real("Checkpoint Every Minutes", 60, "min", Range::positive(),
          "A checkpoint is also written when this much wall time has gone by since the last one: "
          "what a run that is killed loses at most, and what others read of it lags behind. Each "
          "closes a file of every history: a few hundred in all are enough.");
  return list;
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
  return assembleDeck(command_line, *deckParameters());
}
} // namespace asperity::scenario
