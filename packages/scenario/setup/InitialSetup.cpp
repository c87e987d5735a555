#include "scenario/setup/InitialSetup.hpp"

#include "base/Text.hpp"
#include "scenario/setup/FrictionSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <cmath>
#include <limits>
#include <numeric>

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Initial State";
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
    along[c] = nodalValues(list, velocity_names[components == 1 ? 2 : c], path, mesh, nodes);
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
      if (!body.fixed[dof]) {
        values(dof, 0) = local[c];
      }
    }
  }
  return v;
}

namespace
{
constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <class View>
auto toHost(View const& view)
{
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

template <int Dim>
std::string placeOf(Mesh<Dim> const& mesh, int node)
{
  return "at node " + std::to_string(mesh.global_ids[node]) +
         ", x = " + formatPoint<Dim>(mesh.vertices[node]) + ",";
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

// The coefficient that friction needs to bear the traction; the reasons why there may be none.
double balancingCoefficient(InitialFault const& at_start, int i, double speed, double V,
                            double sigma_n, double cohesion, std::string const& place)
{
  ASPERITY_REQUIRE(sigma_n > 0, path << " / State = Stress Balance: " << place
                                     << " there is no normal stress, hence no friction that could "
                                        "bear the shear traction.");
  const int size = static_cast<int>(at_start.velocity.size() / at_start.radiation.size());
  const double driving = product(at_start.traction, at_start.velocity, size, i) / speed;
  const double rest = driving - cohesion - at_start.radiation[i] * V;
  ASPERITY_REQUIRE(rest > 0, path << " / State = Stress Balance: " << place
                                  << " the shear traction along the initial velocity, "
                                  << formatShort(driving) << " Pa, does not exceed the cohesion of "
                                  << formatShort(cohesion) << " Pa and the radiation damping of "
                                  << formatShort(at_start.radiation[i] * V)
                                  << " Pa: friction would have to push. Check the signs of 'Shear "
                                     "Traction' and of the initial velocity.");
  return rest / sigma_n;
}
} // namespace

template <int Dim>
friction::NodeView initialAlpha(ParameterList const& list, Mesh<Dim> const& mesh,
                                std::vector<int> const& nodes, dynamics::Fault const& fault,
                                InitialFault const& at_start)
{
  auto const given = nodalValues(list, "alpha", path, mesh, nodes);
  auto const state = list.get<std::string>("State");
  if (state == "Given") {
    return toDevice(given, "asperity::scenario::alpha");
  }
  auto const sigma_n = toHost(fault.data.sigma_n);
  auto const cohesion = toHost(fault.data.cohesion);
  std::vector<double> V(nodes.size());
  std::vector<double> mu(nodes.size(), none);
  for (int i = 0; i < fault.numNodes(); ++i) {
    auto const place = placeOf(mesh, nodes[i]);
    double speed = 0;
    for (int k = 0; k < fault.num_tangents; ++k) {
      speed = std::hypot(speed, at_start.velocity[i * fault.num_tangents + k]);
    }
    V[i] = fault.slip_factor * speed;
    if (V[i] == 0 && !fault.slides(i)) {
      continue;
    }
    ASPERITY_REQUIRE(V[i] > 0, path << " / State = " << state << ": " << place
                                    << " the initial slip rate is zero, where there is no such "
                                       "state. Give an initial velocity, or State = Given.");
    if (state == "Stress Balance") {
      mu[i] = balancingCoefficient(at_start, i, speed, V[i], sigma_n(i), cohesion(i), place);
    }
  }
  auto const alpha = toDevice(std::vector<double>(nodes.size(), none), "asperity::scenario::alpha");
  auto const V_view = toDevice(V, "asperity::scenario::V");
  if (state == "Steady") {
    fault.state->steadyState(V_view, alpha);
  } else {
    fault.friction->balance(V_view, toDevice(mu, "asperity::scenario::mu"), alpha);
  }
  auto const result = Kokkos::create_mirror_view(alpha);
  Kokkos::deep_copy(result, alpha);
  for (int i = 0; i < fault.numNodes(); ++i) {
    if (V[i] == 0) {
      result(i) = given[i];
    }
    ASPERITY_REQUIRE(std::isfinite(result(i)),
                     path << " / State = " << state << ": " << placeOf(mesh, nodes[i])
                          << " no state does this. Friction has to depend on the state; see the "
                             "parameters of the law.");
  }
  Kokkos::deep_copy(alpha, result);
  return alpha;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template RCP<Vector> initialVelocity(ParameterList const&, Mesh<Dim> const&,                     \
                                       dynamics::Body const&, fem::Constraints<Dim> const&);       \
  template friction::NodeView initialAlpha(ParameterList const&, Mesh<Dim> const&,                 \
                                           std::vector<int> const&, dynamics::Fault const&,        \
                                           InitialFault const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
