#include "scenario/run/RunDeck.hpp"

#include "base/Errors.hpp"
#include "scenario/deck/Coordinates.hpp"
#include "scenario/run/PreparedRun.hpp"
#include "scenario/run/Simulation.hpp"
#include "scenario/setup/DeckDirections.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"

#include <memory>
#include <string>
#include <utility>

namespace asperity::scenario
{
namespace
{
template <int Dim>
std::unique_ptr<PreparedRun<Dim>> prepare(RCP<ParameterList> const& deck,
                                          CommandLine const& command_line,
                                          RCP<const Communicator> const& communicator)
{
  try {
    // 1. The mesh and all that follows from it.
    auto problem = makeProblem<Dim>(*deck, communicator);

    // 2. Where the deck does not say which way is up, that is known only from the mesh. It is set
    // before anything looks at the deck as a whole: the fingerprint that a restart compares, the
    // outputs that read `Up`, and parameters.xml.
    completeDirections(*deck, Dim, problem.discretisation.upright.up);

    // 3. The steps and outputs of a run.
    return std::make_unique<PreparedRun<Dim>>(deck, std::move(problem), command_line);
  } catch (SolveError const& error) {
    throw InputError(std::string("The state at the start cannot be computed. ") + error.what() +
                     " Check Boundary Conditions, Bulk and Initial State.");
  }
}

// Calls `use` with the prepared run, in as many dimensions as the deck's mesh has.
template <class Use>
auto withPreparedRun(RCP<ParameterList> const& deck, CommandLine const& command_line,
                     RCP<const Communicator> const& communicator, Use const& use)
{
  if (meshDimension(deck->sublist(deck_lists::mesh), *communicator) == 3) {
    return use(*prepare<3>(deck, command_line, communicator));
  }
  refuseZ(*deck);
  return use(*prepare<2>(deck, command_line, communicator));
}

template <int Dim>
int run(PreparedRun<Dim>& prepared, CommandLine const& command_line)
{
  return Simulation<Dim>(prepared, command_line).run();
}
} // namespace

Description validateDeck(RCP<ParameterList> const& deck, CommandLine const& command_line,
                         RCP<const Communicator> const& communicator)
{
  return withPreparedRun(deck, command_line, communicator,
                         [](auto const& prepared) { return prepared.description(); });
}

int runDeck(RCP<ParameterList> const& deck, CommandLine const& command_line,
            RCP<const Communicator> const& communicator)
{
  return withPreparedRun(deck, command_line, communicator,
                         [&](auto& prepared) { return run(prepared, command_line); });
}
} // namespace asperity::scenario
