#include "scenario/DeckParameters.hpp"

#include "catalogue/stress/CoulombPlanes.hpp"
#include "dynamics/coupling/CouplingSettings.hpp"
#include "io/OutputSet.hpp"
#include "scenario/deck/Names.hpp"
#include "scenario/deck/Tables.hpp"
#include "scenario/setup/CheckpointSetup.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/mesh/MeshSettings.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

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
} // namespace

RCP<const ParameterList> deckParameters()
{
  auto const list =
    Declare()
      .openSublist(names_list, nameParameters(), meaningOfNames())
      .openSublist(tables_list, tableParameters(), meaningOfTables())
      .sublist(
        deck_lists::mesh, meshParameters(),
        "This list says which region of space the body fills and how it is divided into cells.")
      .sublist(deck_lists::bulk, bulkParameters(),
               "This list describes the material of the body and its gravity.")
      .sublist(deck_lists::friction, frictionParameters(),
               "This list describes friction on the fault and the stress that the fault bears.")
      .openSublist(deck_lists::conditions, boundaryParameters(),
                   "Each list in here, of any name, is one condition on one boundary.")
      .sublist(deck_lists::initial, initialStateParameters(),
               "This list describes the state in which the run starts.")
      .sublist(deck_lists::time, timeParameters(), meaningOfTime())
      .sublist(deck_lists::coupling, dynamics::CouplingSettings::validParameters(),
               "This list controls the fixed-point iteration between rate and state within a step.")
      .sublist(deck_lists::solver, solverParameters(),
               "This list controls TNNMG, the solver of the rate problems.")
      .sublist(deck_lists::output, outputParameters(),
               "This list selects what the run writes to files.")
      .list();
  list->setName("Asperity");
  return list;
}
} // namespace asperity::scenario
