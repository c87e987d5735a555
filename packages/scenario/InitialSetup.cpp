#include "scenario/InitialSetup.hpp"

#include "base/Text.hpp"
#include "scenario/FrictionSetup.hpp"

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
            "Static: the displacement under gravity with a frictionless fault. Zero: none.")
    .field(velocity_names[0], 0., "m/s", Range::any(), "Initial velocity along x (plane strain).")
    .field(velocity_names[1], 0., "m/s", Range::any(), "Initial velocity along y (plane strain).")
    .field(velocity_names[2], 0., "m/s", Range::any(), "Initial velocity along z (antiplane).")
    .choice("Acceleration", "Balanced", {"Balanced", "Zero"},
            "Balanced: from the balance of momentum; quasi-dynamic there is none. Zero: none, "
            "whatever the forces.")
    .choice("State", "Given", {"Given", "Steady", "Stress Balance"},
            "Given: alpha below. Steady: in steady state at the initial slip rate. Stress Balance: "
            "such that friction at the initial slip rate, with the radiation damping if quasi-"
            "dynamic, bears the initial shear traction.")
    .field("alpha", 0., "-", Range::any(),
           "Initial state ln(theta V* / L); 0 is steady sliding at V*.")
    .list();
}

RCP<Vector> initialVelocity(ParameterList const& list, Mesh<2> const& mesh,
                            dynamics::Body const& body, fem::Constraints<2> const& constraints)
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

class Place
{
public:
  Place(Mesh<2> const& mesh, int node) : id_(mesh.global_ids[node]), x_(mesh.vertices[node]) {}

  friend std::ostream& operator<<(std::ostream& out, Place const& place)
  {
    return out << "at node " << place.id_ << " (x = " << formatShort(place.x_[0])
               << ", y = " << formatShort(place.x_[1]) << ")";
  }

private:
  GlobalOrdinal id_;
  Point<2> x_;
};

// The coefficient that friction needs to bear the traction; the reasons why there may be none.
double balancingCoefficient(InitialFault const& at_start, int i, double V, double sigma_n,
                            double cohesion, Place const& place)
{
  ASPERITY_REQUIRE(sigma_n > 0, path << " / State = Stress Balance: " << place
                                     << " there is no normal stress, hence no friction that could "
                                        "bear the shear traction.");
  const double driving = at_start.velocity[i] > 0 ? at_start.traction[i] : -at_start.traction[i];
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

friction::NodeView initialAlpha(ParameterList const& list, Mesh<2> const& mesh,
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
    const Place place(mesh, nodes[i]);
    V[i] = fault.slip_factor * std::abs(at_start.velocity[i]);
    if (V[i] == 0 && fault.fixed[i]) {
      continue;
    }
    ASPERITY_REQUIRE(V[i] > 0, path << " / State = " << state << ": " << place
                                    << " the initial slip rate is zero, where there is no such "
                                       "state. Give an initial velocity, or State = Given.");
    if (state == "Stress Balance") {
      mu[i] = balancingCoefficient(at_start, i, V[i], sigma_n(i), cohesion(i), place);
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
                     path << " / State = " << state << ": " << Place(mesh, nodes[i])
                          << " no state does this. Friction has to depend on it, b > 0.");
  }
  Kokkos::deep_copy(alpha, result);
  return alpha;
}
} // namespace asperity::scenario
