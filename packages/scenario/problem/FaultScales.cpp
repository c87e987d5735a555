#include "scenario/problem/FaultScales.hpp"

#include "base/parallel/Reductions.hpp"
#include "friction/Registry.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
constexpr double slow = 0.1;          // a slow slip rate, as a share of a seismic one
constexpr double seismic_rates = 20.; // b sigma_n / Z, as a multiple of a seismic slip rate
constexpr double creep_front = 1e-6;  // [m/s] of a front of slip without an earthquake
// The slip rates between which steady friction is searched for weakening [m/s], and their number in
// each decade.
constexpr double slowest_rate = 1e-12;
constexpr double fastest_rate = 10;
constexpr double rates_per_decade = 16;

// mu(V, alpha) with the same slip rate [m/s] at all nodes.
std::vector<double> coefficientAt(dynamics::Fault const& fault, double rate,
                                  ConstNodeView const& alpha)
{
  auto const& surface = fault.surface();
  const int num_nodes = surface.numNodes();
  const double speed = rate / surface.slipFactor();
  const BlockView v("asperity::scenario::uniformVelocity", num_nodes, surface.numTangents());
  Kokkos::parallel_for(
    "asperity::scenario::setUniformVelocity", RangePolicy(0, num_nodes),
    KOKKOS_LAMBDA(int node) { v(node, 0) = speed; });
  const NodeView mu("asperity::scenario::frictionCoefficient", num_nodes);
  fault.friction().coefficient(v, alpha, mu);
  return toVector(mu);
}

bool weakensAtHighRates(dynamics::Fault const& fault)
{
  return friction::stateLaws().at(fault.laws().state).weakens_at_high_rates;
}

NodeView uniform(double value, int num_nodes)
{
  const NodeView view("asperity::scenario::uniform", num_nodes);
  Kokkos::deep_copy(view, value);
  return view;
}

std::vector<double> steadyFriction(dynamics::Fault const& fault, double rate)
{
  const int num_nodes = fault.surface().numNodes();
  const NodeView alpha("asperity::scenario::steadyState", num_nodes);
  fault.state().steadyState(uniform(rate, num_nodes), alpha);
  return coefficientAt(fault, rate, alpha);
}

// (num_nodes) the largest -d(mu_ss)/d(ln V) over slip rates from a plate's to a rupture's.
std::vector<double> largestFall(dynamics::Fault const& fault)
{
  const double ratio = std::pow(10, 1 / rates_per_decade);
  auto before = steadyFriction(fault, slowest_rate);
  std::vector<double> fall(before.size(), -1);
  for (double rate = slowest_rate * ratio; rate <= fastest_rate; rate *= ratio) {
    auto const now = steadyFriction(fault, rate);
    for (std::size_t node = 0; node < now.size(); ++node) {
      fall[node] = std::max(fall[node], (before[node] - now[node]) / std::log(ratio));
    }
    before = now;
  }
  return fall;
}

// (num_nodes) the shear stress that friction bears before slip has weakened it [Pa]: under slip
// weakening mu_s, under rate-and-state friction that of steady creep.
std::vector<double> strengthOf(dynamics::Fault const& fault, bool weakens_with_slip,
                               std::vector<double> const& sigma_n)
{
  const int num_nodes = fault.surface().numNodes();
  auto strength = weakens_with_slip ? coefficientAt(fault, creep_front, uniform(0, num_nodes))
                                    : steadyFriction(fault, creep_front);
  auto const cohesion = toVector(fault.laws().cohesion);
  for (int node = 0; node < num_nodes; ++node) {
    strength[node] = strength[node] * sigma_n[node] + cohesion[node];
  }
  return strength;
}

std::optional<dynamics::FrictionOfNodes> frictionOfNodes(LawsAtNodes const& laws,
                                                         dynamics::Fault const& fault,
                                                         ConstNodeView const& sigma_n,
                                                         std::vector<double> const& driving)
{
  auto const sensitivity = laws.sensitivities();
  auto const drop = laws.strengthDrops();
  auto const slip_distance = laws.slipDistances();
  if ((!sensitivity && !drop) || !slip_distance) {
    return std::nullopt;
  }
  dynamics::FrictionOfNodes of_nodes;
  of_nodes.L = *slip_distance;
  of_nodes.sigma_n = toVector(sigma_n);
  if (drop) {
    of_nodes.drop = *drop;
  } else {
    for (auto const& [a, b] : *sensitivity) {
      of_nodes.a.push_back(a);
      of_nodes.b.push_back(b);
    }
    if (weakensAtHighRates(fault)) {
      auto const fall = largestFall(fault);
      for (std::size_t node = 0; node < fall.size(); ++node) {
        of_nodes.a[node] = of_nodes.b[node] - fall[node];
      }
    }
  }
  of_nodes.can_slip = dynamics::canSlip(strengthOf(fault, drop.has_value(), of_nodes.sigma_n),
                                        driving, of_nodes.sigma_n, *fault.surface().communicator());
  return of_nodes;
}

double barrierShare(fem::FaultSurface const& surface, dynamics::FrictionOfNodes const& friction)
{
  double barrier = 0;
  for (int node = 0; node < surface.numNodes(); ++node) {
    barrier += friction.canSlip(node) ? 0 : surface[node].weight;
  }
  return sumOverRanks(barrier, *surface.communicator()) / surface.totalWeight();
}

// Sets the front of slip to expect: at a seismic slip rate in the part that weakens with the slip
// rate, or a creeping one if no part does.
template <int Dim>
void findFront(FaultScales& scales, SetupContext<Dim> const& context, dynamics::Fault const& fault,
               dynamics::State const& initial, dynamics::FrictionOfNodes const& friction)
{
  auto const& surface = fault.surface();
  auto const& found = scales.resolution;
  std::vector<double> modulus;
  std::vector<bool> counts;
  for (int node = 0; node < surface.numNodes(); ++node) {
    modulus.push_back(dynamics::slipModulus(context.site.materials[node], context.components(),
                                            surface.otherSide()));
    counts.push_back(surface.slides(node) && friction.canSlip(node) &&
                     (!found || friction.b[node] > friction.a[node]));
  }
  const dynamics::FrontZone zone(modulus, friction.b, friction.L,
                                 dynamics::largerCells(context.discretisation.mesh, surface),
                                 counts, surface.communicator());
  const double rate = found ? found->slip_distance / found->seismic_time : creep_front;
  auto const expected =
    zone.narrowest(fault.state(), uniform(rate, surface.numNodes()), fault.given(initial));
  constexpr double narrow = 0.5; // of the cohesive zone
  if (!expected || (found && expected->length > narrow * found->cohesive_zone)) {
    return;
  }
  scales.front = ExpectedFront{rate, expected->cells, expected->length};
  // Laws that weaken at high slip rates have seismic fronts, which arrive in time on cells that do
  // not resolve them (docs/validation/weakening.md).
  if (!weakensAtHighRates(fault)) {
    scales.zone = zone;
  }
}
} // namespace

double FaultScales::slipDistance() const { return resolution ? resolution->slip_distance : 0; }

double FaultScales::slowRate() const
{
  return resolution ? slow * resolution->slip_distance / resolution->seismic_time : 0;
}

double FaultScales::waveRate() const
{
  return resolution ? resolution->slip_distance / (seismic_rates * resolution->seismic_time) : 0;
}

template <int Dim>
FaultScales faultScales(SetupContext<Dim> const& context, LawsAtNodes const& laws,
                        dynamics::Fault const& fault, dynamics::State const& initial,
                        std::vector<double> const& driving)
{
  FaultScales scales;
  auto const of_nodes = frictionOfNodes(laws, fault, fault.given(initial).sigma_n, driving);
  if (!of_nodes) {
    return scales;
  }
  auto const& surface = fault.surface();
  scales.resolution = dynamics::faultResolution(
    context.discretisation.mesh, surface, context.components(), context.site.materials, *of_nodes);
  scales.barrier = barrierShare(surface, *of_nodes);
  auto const& found = scales.resolution;
  if (found && !dynamics::isTooShort(*found, found->unstable_wavelength)) {
    scales.weakening = dynamics::rateWeakeningDistances(*of_nodes);
  }
  if (of_nodes->drop.empty()) {
    findFront(scales, context, fault, initial, *of_nodes);
  }
  return scales;
}

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template FaultScales faultScales(SetupContext<DIM> const&, LawsAtNodes const&,                   \
                                   dynamics::Fault const&, dynamics::State const&,                 \
                                   std::vector<double> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
