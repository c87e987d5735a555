#include "dynamics/initial/InitialAlpha.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "dynamics/fault/FaultMotion.hpp"

#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Where = std::function<std::string(int)>;

// The coefficients of friction(num_nodes) that balance the traction at the slip rates V, nan where
// V = 0.
std::vector<double> balancingCoefficients(Fault const& fault, GivenAtStart const& start,
                                          std::vector<double> const& V, Where const& where)
{
  auto const w = toHost(start.w);
  auto const sigma_n = toHost(start.sigma_n);
  auto const cohesion = toHost(fault.laws().cohesion);
  auto const& eta = fault.laws().radiation_damping;
  std::vector<double> mu(V.size(), nan);
  for (std::size_t i = 0; i < V.size(); ++i) {
    if (V[i] == 0) {
      continue;
    }
    const int node = static_cast<int>(i);
    ASPERITY_REQUIRE(sigma_n(i) > 0, where(node)
                                       << " there is no normal stress, hence no friction that "
                                          "could bear the shear traction.");
    double power = 0;
    for (std::size_t k = 0; k < w.extent(1); ++k) {
      power += start.traction[i * w.extent(1) + k] * w(i, k);
    }
    const double driving = power / (V[i] / fault.surface().slipFactor());
    const double radiation = eta.empty() ? 0 : eta[i] * V[i];
    const double rest = driving - cohesion(i) - radiation;
    ASPERITY_REQUIRE(rest > 0, where(node)
                                 << " the shear traction along the initial velocity, "
                                 << formatShort(driving) << " Pa, does not exceed the cohesion of "
                                 << formatShort(cohesion(i)) << " Pa and the radiation damping of "
                                 << formatShort(radiation)
                                 << " Pa: friction would have to push. Check the signs of 'Shear "
                                    "Traction' and of the initial velocity.");
    mu[i] = rest / sigma_n(i);
  }
  return mu;
}

std::string howToSlip(fem::FaultSurface const& surface, int node)
{
  std::string text;
  for (int k = 0; k < surface.numTangents(); ++k) {
    if (surface.held(node, k)) {
      text = "A boundary condition decides on a part of the velocity there. ";
    }
  }
  return text +
         (surface.otherSide().is_inside
            ? "Give 'Slip Rate' a value there, since a velocity is the same on both sides of the "
              "fault, or choose State = Given."
            : "Give an initial velocity along the fault or 'Slip Rate', or choose State = Given.");
}
} // namespace

NodeView initialAlpha(Fault const& fault, AlphaAtStart kind, GivenAtStart const& start,
                      Where const& where)
{
  auto const alpha = toDevice(start.given_alpha, "asperity::dynamics::alpha");
  if (kind == AlphaAtStart::given) {
    return alpha;
  }
  auto const& surface = fault.surface();
  const int num_nodes = surface.numNodes();
  const NodeView rates("asperity::dynamics::V", num_nodes);
  slipRate(surface, start.w, rates);
  auto const V = toVector(rates);
  auto const* const wanted =
    kind == AlphaAtStart::steady ? "is steady" : "balances the shear traction";
  for (int node = 0; node < num_nodes; ++node) {
    ASPERITY_REQUIRE(V[node] > 0 || !surface.slides(node),
                     where(node) << " the initial slip rate is zero, at which no state alpha "
                                 << wanted << ". " << howToSlip(surface, node));
  }
  // The kernels leave nan where there is no such state.
  auto const found = toDevice(std::vector<double>(num_nodes, nan), "asperity::dynamics::alpha");
  if (kind == AlphaAtStart::steady) {
    fault.state().steadyState(rates, found);
  } else {
    fault.friction().stateFor(
      rates, toDevice(balancingCoefficients(fault, start, V, where), "asperity::dynamics::mu"),
      found);
  }
  auto const result = toHost(found);
  for (int node = 0; node < num_nodes; ++node) {
    if (V[node] == 0) {
      result(node) = start.given_alpha[node];
    }
    ASPERITY_REQUIRE(std::isfinite(result(node)),
                     where(node) << " no state alpha " << wanted << " at the initial slip rate, "
                                 << formatShort(V[node])
                                 << " m/s. Friction has to depend on the state; see the parameters "
                                    "of the law.");
  }
  Kokkos::deep_copy(alpha, result);
  return alpha;
}
} // namespace asperity::dynamics
