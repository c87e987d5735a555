#include "scenario/problem/Problem.hpp"

#include "fem/BodyMatrices.hpp"
#include "fem/SupportWeights.hpp"
#include "scenario/problem/FaultAtStart.hpp"
#include "scenario/problem/InitialState.hpp"
#include "scenario/problem/LoadedBody.hpp"
#include "scenario/problem/OpeningRequirements.hpp"
#include "scenario/problem/StartRequirements.hpp"
#include "scenario/problem/StaticStart.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/friction/FaultLoads.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <utility>

namespace asperity::scenario
{
namespace
{
// Empty where nothing presses across the fault.
template <int Dim>
dynamics::ReactionSinceStart reactionSinceStart(SetupContext<Dim> const& context,
                                                dynamics::Body const& body,
                                                dynamics::State const& initial)
{
  auto const& discretisation = context.discretisation;
  auto const& surface = *context.site.surface;
  if (!context.bodyPresses() || surface.numGlobalNodes() == 0) {
    return {};
  }
  return dynamics::reactionSince(
    initial.motion(), body,
    std::make_shared<dynamics::NormalReaction>(
      body, surface, discretisation.frames(),
      fem::supportWeights(discretisation.mesh, surface, discretisation.boundary.velocities)));
}
} // namespace

template <int Dim>
Problem<Dim> makeProblem(ParameterList const& deck, RCP<const Communicator> const& communicator)
{
  // 1. What the deck says; nothing below reads the deck.
  auto settings = DeckSettings::from(deck);

  // 2. The mesh with its unknowns, constraints and rock.
  auto discretisation = discretise<Dim>(settings, communicator);
  auto const& mesh = discretisation.mesh;
  auto const solver = makeSolverSettings(settings.solver, communicator->getSize(), Dim,
                                         mesh.num_global_vertices * discretisation.components());

  // 3. The body, its loads, and where its fault lies.
  auto matrices = fem::assembleBody<Dim>(mesh, *discretisation.dofs, discretisation.frames(),
                                         discretisation.rock.materials,
                                         discretisation.rock.branches, discretisation.patches);
  auto site = makeFaultSite(settings, discretisation, *matrices.stiffness->getCrsGraph());
  const SetupContext<Dim> context{settings, discretisation, solver, site};
  auto loaded = makeBody(context, std::move(matrices));

  // 4. The fault under the normal stress at the start.
  auto const start = staticStart(context, loaded.body, *loaded.static_load);
  auto [fault, laws, warnings_of_stress] = makeFault(context, start.normal_stress);
  requireOpening(context, fault);

  // 5. The state at the start.
  auto initial =
    makeInitialState(context, loaded.body, fault,
                     {start.displacement, loaded.traction.at(0), loaded.traction.direction()});
  requireNoInitialYield(discretisation, loaded.body, *initial.u);
  auto const across = reactionSinceStart(context, loaded.body, initial);
  const bool follows = fault.normalStress().change() != dynamics::NormalStressChange::fixed;
  dynamics::Model model{std::move(loaded.body), std::move(fault), std::move(initial),
                        follows ? across : dynamics::ReactionSinceStart()};

  // 6. What users should know about it.
  auto scales = model.fault.stateDecides()
                  ? faultScales(context, laws, model.fault, model.initial,
                                loaded.traction.largest(discretisation.samples))
                  : FaultScales();
  auto findings = findingsOf(context, model, loaded.traction, start, warnings_of_stress);
  return {communicator,
          std::move(settings),
          std::move(discretisation),
          solver,
          std::move(model),
          std::move(laws),
          std::move(site.materials),
          std::move(scales),
          std::move(findings),
          across};
}

template Problem<2> makeProblem(ParameterList const&, RCP<const Communicator> const&);
template Problem<3> makeProblem(ParameterList const&, RCP<const Communicator> const&);
} // namespace asperity::scenario
