#include "scenario/setup/friction/FaultScales.hpp"

#include "scenario/setup/friction/LawSetup.hpp"

namespace asperity::scenario
{
namespace
{
constexpr double slow = 0.1;          // of a seismic slip rate
constexpr double seismic_rates = 20.; // b sigma_n / Z in one, see FaultResolution::seismic_time

std::optional<dynamics::FrictionOfNodes> frictionOfNodes(ParameterList const& friction,
                                                         FieldNodes const& nodes,
                                                         ConstNodeView const& sigma_n)
{
  auto const sensitivity = sensitivities(friction, nodes);
  auto const drop = strengthDrops(friction, nodes);
  auto const slip_distance = slipDistances(friction, nodes);
  if ((!sensitivity && !drop) || !slip_distance) {
    return std::nullopt;
  }
  dynamics::FrictionOfNodes of_nodes;
  if (drop) {
    of_nodes.drop = *drop;
  } else {
    for (auto const& [a, b] : *sensitivity) {
      of_nodes.a.push_back(a);
      of_nodes.b.push_back(b);
    }
  }
  of_nodes.L = *slip_distance;
  of_nodes.sigma_n = toVector(sigma_n);
  return of_nodes;
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
FaultScales faultScales(Mesh<Dim> const& mesh, fem::FaultSurface const& surface, int components,
                        std::vector<fem::Material> const& materials, ParameterList const& friction,
                        FieldNodes const& nodes, ConstNodeView const& sigma_n)
{
  FaultScales scales;
  auto const of_nodes = frictionOfNodes(friction, nodes, sigma_n);
  if (of_nodes) {
    scales.resolution = dynamics::faultResolution(mesh, surface, components, materials, *of_nodes);
  }
  auto const& found = scales.resolution;
  if (found && !dynamics::isTooShort(*found, found->unstable_wavelength)) {
    scales.weakening = dynamics::rateWeakeningDistances(*of_nodes);
  }
  return scales;
}

template FaultScales faultScales(Mesh<2> const&, fem::FaultSurface const&, int,
                                 std::vector<fem::Material> const&, ParameterList const&,
                                 FieldNodes const&, ConstNodeView const&);
template FaultScales faultScales(Mesh<3> const&, fem::FaultSurface const&, int,
                                 std::vector<fem::Material> const&, ParameterList const&,
                                 FieldNodes const&, ConstNodeView const&);
} // namespace asperity::scenario
