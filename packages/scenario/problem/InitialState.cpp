#include "scenario/problem/InitialState.hpp"

#include "base/parallel/Reductions.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "dynamics/initial/InitialAcceleration.hpp"
#include "dynamics/initial/InitialAlpha.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/NodalField.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <numeric>

namespace asperity::scenario
{
namespace
{
// nodes: the owned ones.
RCP<Vector> initialVelocity(ParameterList const& list, FieldNodes const& nodes,
                            dynamics::Body const& body, fem::NodalFrames const& frames)
{
  const int components = frames.components();
  std::vector<double> along_axes(nodes.ids.size() * components);
  for (int c = 0; c < components; ++c) {
    auto const along =
      nodalValues(list, initial_entries::velocity[components == 1 ? 2 : c], initial_path, nodes);
    for (std::size_t node = 0; node < nodes.ids.size(); ++node) {
      along_axes[node * components + c] = along[node];
    }
  }
  auto const unknowns = fem::unknownsOf(frames, along_axes);
  auto v = body.vector();
  body.prescribed_velocity(0, *v);
  auto const values = v->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (std::size_t dof = 0; dof < unknowns.size(); ++dof) {
    if (!body.held[static_cast<int>(dof)]) {
      values(dof, 0) = unknowns[dof];
    }
  }
  return v;
}

// Where the deck gives the slip rate, it decides on the tangential unknowns of the fault.
void setSlipRate(ParameterList const& list, FieldNodes const& nodes,
                 fem::FaultSurface const& surface, std::vector<double> rates, Vector& v)
{
  if (!isGiven(list, initial_entries::slip_rate)) {
    return;
  }
  auto const size = nodalValues(list, initial_entries::slip_rate, initial_path, nodes);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    rates[i] *= size[i / surface.numTangents()];
  }
  dynamics::setSlipRate(surface, rates, v);
}

NodeView initialAlpha(dynamics::AlphaAtStart kind, ParameterList const& list,
                      FieldNodes const& nodes, dynamics::Fault const& fault,
                      dynamics::State const& state, std::vector<double> const& traction)
{
  auto const& surface = fault.surface();
  const BlockView w("asperity::scenario::w", surface.numNodes(), surface.numTangents());
  dynamics::gatherSlip(surface, *state.v, w);
  return dynamics::initialAlpha(fault, kind,
                                {nodalValues(list, initial_entries::alpha, initial_path, nodes),
                                 traction, fault.given(state).sigma_n, w},
                                [&](int i) {
                                  return joinPath(initial_path, initial_entries::state) + " = " +
                                         list.get<std::string>(initial_entries::state) +
                                         ": at node " + std::to_string(nodes.ids[i]) +
                                         ", x = " + nodes.text(i) + ",";
                                });
}
} // namespace

template <int Dim>
dynamics::State makeInitialState(SetupContext<Dim> const& context, dynamics::Body const& body,
                                 dynamics::Fault const& fault, StartOfRun const& start)
{
  auto const& settings = context.settings.initial;
  auto const& list = context.settings.lists.initial;
  auto const& mesh = context.discretisation.mesh;
  auto const& at_fault = context.site.nodes;
  const int num_nodes = fault.surface().numNodes();
  std::vector<int> owned(mesh.num_owned);
  std::iota(owned.begin(), owned.end(), 0);
  dynamics::State state;
  state.u = start.displacement;
  state.v = initialVelocity(list, FieldNodes(mesh, owned), body, context.discretisation.frames());
  setSlipRate(list, at_fault, fault.surface(), start.slip_direction, *state.v);
  state.a = body.vector();
  state.jerk = body.vector();
  for (std::size_t k = 0; k < body.matrices.branches.size(); ++k) {
    state.branches.push_back(rcp(new Vector(*state.u, Teuchos::Copy)));
  }
  if (body.cells) {
    state.inelastic = body.cells->none();
  }
  state.sigma_n = NodeView("asperity::scenario::sigma_n", num_nodes);
  fault.normalStress().at(0, state.sigma_n);
  fault.normalStress().raiseToFloor(state.sigma_n);
  state.alpha = NodeView("asperity::scenario::alpha", num_nodes);
  state.alpha_of_rate = NodeView("asperity::scenario::alphaOfRate", num_nodes);
  state.alpha_defect = NodeView("asperity::scenario::alphaDefect", num_nodes);
  for (auto const& process : fault.processes()) {
    auto const fields = process->fields(state);
    state.added.insert(state.added.end(), fields.begin(), fields.end());
  }
  state.alpha = initialAlpha(settings.alpha, list, at_fault, fault, state, start.traction);
  auto const given = fault.given(state);
  Kokkos::deep_copy(state.alpha_of_rate, given.alpha);
  if (settings.is_balanced && !context.settings.bulk.isQuasiDynamic()) {
    auto const& time = context.settings.time;
    double dt = std::min(time.largest_step, time.final_time) * 1e-6;
    dt = std::min(dt, time.smallest_step.value_or(dt));
    auto const load = body.vector();
    body.load(0, *load);
    state.a = dynamics::prescribedAcceleration(body, dt);
    state.a =
      dynamics::initialAcceleration(body, fault, context.solver, *load, state.motion(), given);
  }
  return state;
}

// In a model with inertia it may be that of a wave.
template <int Dim>
std::optional<Warning> warnOfVelocity(SetupContext<Dim> const& context)
{
  auto const& list = context.settings.lists.initial;
  auto const& surface = *context.site.surface;
  if (!surface.otherSide().is_inside || surface.numSliding() == 0 ||
      isGiven(list, initial_entries::slip_rate) || !context.settings.bulk.isQuasiDynamic()) {
    return std::nullopt;
  }
  double largest = 0;
  for (auto const* name : initial_entries::velocity) {
    for (const double velocity : nodalValues(list, name, initial_path, context.site.nodes)) {
      largest = std::max(largest, std::abs(velocity));
    }
  }
  if (maxOverRanks(largest, *surface.communicator()) == 0) {
    return std::nullopt;
  }
  return Warning{"initial velocity",
                 std::string(initial_path) +
                   " has a velocity, which is the same on both sides of a two-sided fault: the "
                   "fault starts at rest. Give 'Slip Rate' instead."};
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::optional<Warning> warnOfVelocity(SetupContext<Dim> const&);                        \
  template dynamics::State makeInitialState(SetupContext<Dim> const&, dynamics::Body const&,       \
                                            dynamics::Fault const&, StartOfRun const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
