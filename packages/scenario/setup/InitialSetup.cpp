#include "scenario/setup/InitialSetup.hpp"

#include "base/Text.hpp"
#include "dynamics/FaultMotion.hpp"
#include "dynamics/InitialState.hpp"
#include "mesh/PointText.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/NodalField.hpp"

#include <Tpetra_Vector.hpp>

#include <cmath>
#include <limits>
#include <numeric>

namespace asperity::scenario
{
namespace
{
constexpr std::array<char const*, 3> velocity_names = {"Velocity X", "Velocity Y", "Velocity Z"};
} // namespace

RCP<const ParameterList> initialStateParameters()
{
  return Declare()
    .choice("Displacement", "Static", {"Static", "Zero"},
            "Selects the initial displacement. Static: it balances gravity on a fault without "
            "friction. Zero: it is zero.")
    .field(velocity_names[0], 0., "m/s", Range::any(),
           "The body starts with this velocity along x. An antiplane model has none.")
    .field(velocity_names[1], 0., "m/s", Range::any(),
           "The body starts with this velocity along y. An antiplane model has none.")
    .field(velocity_names[2], 0., "m/s", Range::any(),
           "The body starts with this velocity along z. Only antiplane models and solids have it.")
    .field("Slip Rate", optional, "m/s", Range::any(),
           "The fault starts with this slip rate, in place of the one that follows from the "
           "velocity. It points along the tangent, in three dimensions along 'Slip Direction'. A "
           "two-sided fault needs it, since the velocity is the same on both of its sides.")
    .choice("Acceleration", "Balanced", {"Balanced", "Zero"},
            "Selects the initial acceleration. Balanced: it follows from the balance of momentum; "
            "a quasi-dynamic model has none. Zero: it is zero whatever the forces are.")
    .choice("State", "Given", {"Given", "Steady", "Stress Balance"},
            "Selects the initial state on the fault. Given: it is the entry 'alpha'. Steady: it is "
            "the steady state at the initial slip rate. Stress Balance: friction at the initial "
            "slip rate, together with the radiation damping of a quasi-dynamic model, bears the "
            "initial shear traction.")
    .field("alpha", 0., "-", Range::any(),
           "The fault starts with this state alpha = ln(theta V* / L); 0 is steady sliding at V*.")
    .list();
}

bool startsStatic(ParameterList const& list)
{
  return list.get<std::string>("Displacement") == "Static";
}

namespace
{
// Of the values at the two vertices of a pair: the nodes carry the jump at `plus`, the mean at
// `minus` (fem::VertexTerms).
void toMeanAndJump(double& plus, double& minus)
{
  const double jump = plus - minus;
  minus += jump / 2;
  plus = jump;
}

template <int Dim>
RCP<Vector> initialVelocity(ParameterList const& list, Mesh<Dim> const& mesh,
                            dynamics::Body const& body, fem::Constraints<Dim> const& constraints)
{
  const int components = body.dofs->components();
  auto v = body.vector();
  body.prescribed_velocity(0, *v);
  std::vector<int> nodes(mesh.num_owned);
  std::iota(nodes.begin(), nodes.end(), 0);
  std::vector<std::vector<double>> along(components);
  for (int c = 0; c < components; ++c) {
    along[c] =
      nodalValues(list, velocity_names[components == 1 ? 2 : c], initial_path, mesh, nodes);
  }
  for (auto const& split : mesh.splits) {
    for (int c = 0; c < components && split.plus < mesh.num_owned; ++c) {
      toMeanAndJump(along[c][split.plus], along[c][split.minus]);
    }
  }
  auto const values = v->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int node = 0; node < mesh.num_owned; ++node) {
    std::array<double, 3> along_axes{};
    std::array<double, 3> local{};
    for (int c = 0; c < components; ++c) {
      along_axes[c] = along[c][node];
    }
    constraints.frames().toFrame(node, along_axes.data(), local.data());
    for (int c = 0; c < components; ++c) {
      const int dof = body.dofs->dof(node, c);
      if (!body.held[dof]) {
        values(dof, 0) = local[c];
      }
    }
  }
  return v;
}

// Where the deck gives the slip rate, it decides on the tangential unknowns of the fault.
template <int Dim>
void setSlipRate(ParameterList const& list, Mesh<Dim> const& mesh, fem::FaultSurface const& surface,
                 std::vector<double> const& direction, Vector& v)
{
  if (!isGiven(list, "Slip Rate")) {
    return;
  }
  auto const rate = nodalValues(list, "Slip Rate", initial_path, mesh, surface.vertices());
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      if (!surface.held(node, k)) {
        const double slip = rate[node] * direction[node * surface.numTangents() + k];
        values(surface[node].dofs[k], 0) =
          (slip - surface.plateRate(node, k)) / surface.slipFactor();
      }
    }
  }
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <int Dim>
std::string placeOf(Mesh<Dim> const& mesh, int node)
{
  return "at node " + std::to_string(mesh.global_ids[node]) +
         ", x = " + mesh::text(mesh.vertices[node]) + ",";
}

// Of the vectors of node i.
double product(std::vector<double> const& a, std::vector<double> const& b, int num_tangents, int i)
{
  double sum = 0;
  for (int k = 0; k < num_tangents; ++k) {
    sum += a[i * num_tangents + k] * b[i * num_tangents + k];
  }
  return sum;
}

// The data from which the initial state of the fault follows.
struct InitialFault
{
  std::vector<double> const& traction;  // (num_nodes, T)
  std::vector<double> velocity;         // (num_nodes, T) slip rate / slip factor [m/s]
  std::vector<double> const& radiation; // (num_nodes)
};

// The coefficient of friction that balances the traction. Throws InputError if there is none.
double balancingCoefficient(InitialFault const& at_start, int i, double speed, double V,
                            double sigma_n, double cohesion, std::string const& place)
{
  ASPERITY_REQUIRE(sigma_n > 0, initial_path
                                  << " / State = Stress Balance: " << place
                                  << " there is no normal stress, hence no friction that could "
                                     "bear the shear traction.");
  const int size = static_cast<int>(at_start.velocity.size() / at_start.radiation.size());
  const double driving = product(at_start.traction, at_start.velocity, size, i) / speed;
  const double rest = driving - cohesion - at_start.radiation[i] * V;
  ASPERITY_REQUIRE(rest > 0, initial_path
                               << " / State = Stress Balance: " << place
                               << " the shear traction along the initial velocity, "
                               << formatShort(driving) << " Pa, does not exceed the cohesion of "
                               << formatShort(cohesion) << " Pa and the radiation damping of "
                               << formatShort(at_start.radiation[i] * V)
                               << " Pa: friction would have to push. Check the signs of 'Shear "
                                  "Traction' and of the initial velocity.");
  return rest / sigma_n;
}

template <int Dim>
friction::NodeView initialAlpha(ParameterList const& list, Mesh<Dim> const& mesh,
                                dynamics::Fault const& fault, friction::NodeView const& normal,
                                InitialFault const& at_start)
{
  auto const& surface = fault.surface();
  auto const nodes = surface.vertices();
  const int num_tangents = surface.numTangents();
  auto const given = nodalValues(list, "alpha", initial_path, mesh, nodes);
  auto const state = list.get<std::string>("State");
  if (state == "Given") {
    return toDevice(given, "asperity::scenario::alpha");
  }
  auto const sigma_n = toHost(normal);
  auto const cohesion = toHost(fault.laws().cohesion);
  std::vector<double> V(nodes.size());
  std::vector<double> mu(nodes.size(), none);
  for (int i = 0; i < surface.numNodes(); ++i) {
    auto const place = placeOf(mesh, nodes[i]);
    double speed = 0;
    for (int k = 0; k < num_tangents; ++k) {
      speed = std::hypot(speed, at_start.velocity[i * num_tangents + k]);
    }
    V[i] = surface.slipFactor() * speed;
    if (V[i] == 0 && !surface.slides(i)) {
      continue;
    }
    ASPERITY_REQUIRE(V[i] > 0, initial_path
                                 << " / State = " << state << ": " << place
                                 << " the initial slip rate is zero, for which there is no such "
                                    "state. Give an initial velocity, or State = Given.");
    if (state == "Stress Balance") {
      mu[i] = balancingCoefficient(at_start, i, speed, V[i], sigma_n(i), cohesion(i), place);
    }
  }
  auto const alpha = toDevice(std::vector<double>(nodes.size(), none), "asperity::scenario::alpha");
  auto const V_view = toDevice(V, "asperity::scenario::V");
  if (state == "Steady") {
    fault.state().steadyState(V_view, alpha);
  } else {
    fault.friction().stateFor(V_view, toDevice(mu, "asperity::scenario::mu"), alpha);
  }
  auto const result = Kokkos::create_mirror_view(alpha);
  Kokkos::deep_copy(result, alpha);
  for (int i = 0; i < surface.numNodes(); ++i) {
    if (V[i] == 0) {
      result(i) = given[i];
    }
    ASPERITY_REQUIRE(
      std::isfinite(result(i)),
      initial_path << " / State = " << state << ": " << placeOf(mesh, nodes[i])
                   << " no state does this. Friction has to depend on the state; see the "
                      "parameters of the law.");
  }
  Kokkos::deep_copy(alpha, result);
  return alpha;
}

// As a difference quotient over dt [s], which is small beside all steps.
RCP<Vector> prescribedAcceleration(dynamics::Body const& body, double dt)
{
  auto result = body.vector();
  auto const at_zero = body.vector();
  body.prescribed_velocity(dt, *result);
  body.prescribed_velocity(0, *at_zero);
  result->update(-1 / dt, *at_zero, 1 / dt);
  return result;
}

} // namespace

template <int Dim>
dynamics::State makeInitialState(ParameterList const& deck, Mesh<Dim> const& mesh,
                                 fem::Constraints<Dim> const& constraints,
                                 dynamics::Body const& body, dynamics::Fault const& fault,
                                 dynamics::RateSolverSettings const& solver,
                                 StartOfRun const& start)
{
  auto const& list = deck.sublist("Initial State");
  const int num_nodes = fault.surface().numNodes();
  dynamics::State state;
  state.u = start.displacement;
  state.v = initialVelocity(list, mesh, body, constraints);
  setSlipRate(list, mesh, fault.surface(), start.slip_direction, *state.v);
  state.a = body.vector();
  state.jerk = body.vector();
  state.sigma_n = friction::NodeView("asperity::scenario::sigma_n", num_nodes);
  fault.normalStress().at(0, state.sigma_n);
  fault.normalStress().raiseToFloor(state.sigma_n);
  state.alpha = initialAlpha(
    list, mesh, fault, state.sigma_n,
    {start.traction, dynamics::slipUnknowns(fault.surface(), *state.v), start.radiation});
  state.alpha_of_rate = friction::NodeView("asperity::scenario::alphaOfRate", num_nodes);
  Kokkos::deep_copy(state.alpha_of_rate, state.alpha);
  if (list.get<std::string>("Acceleration") == "Balanced" && !quasiDynamic(deck.sublist("Bulk"))) {
    const double dt = deck.sublist("Time Stepping").get<double>("Largest Step") * 1e-6;
    auto const load = body.vector();
    body.load(0, *load);
    state.a =
      dynamics::initialAcceleration(body, fault, solver, *load, *prescribedAcceleration(body, dt),
                                    *state.u, *state.v, {state.alpha, state.sigma_n});
  }
  return state;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template dynamics::State makeInitialState(                                                       \
    ParameterList const&, Mesh<Dim> const&, fem::Constraints<Dim> const&, dynamics::Body const&,   \
    dynamics::Fault const&, dynamics::RateSolverSettings const&, StartOfRun const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
