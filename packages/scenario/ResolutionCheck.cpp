#include "scenario/ResolutionCheck.hpp"

#include "base/Text.hpp"
#include "scenario/setup/LawSetup.hpp"

#include <cmath>

namespace asperity::scenario
{
namespace
{
constexpr double enough_cells = 3; // per cohesive zone

// Estimates: three digits.
std::string rounded(double value)
{
  const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
  return formatShort(std::round(value / unit) * unit);
}

} // namespace

template <int Dim>
std::optional<dynamics::FaultResolution> faultResolution(Problem<Dim> const& problem,
                                                         ParameterList const& friction)
{
  auto const nodes = problem.surface->vertices();
  auto const sensitivity = sensitivities(friction, problem.mesh, nodes);
  auto const slip_distance = slipDistances(friction, problem.mesh, nodes);
  if (!sensitivity || !slip_distance) {
    return std::nullopt;
  }
  dynamics::FrictionOfNodes of_nodes;
  for (auto const& [a, b] : *sensitivity) {
    of_nodes.a.push_back(a);
    of_nodes.b.push_back(b);
  }
  of_nodes.L = *slip_distance;
  auto const sigma_n = toHost(problem.initial.sigma_n);
  of_nodes.sigma_n.assign(sigma_n.data(), sigma_n.data() + sigma_n.extent(0));
  return dynamics::faultResolution(problem.mesh, *problem.surface, problem.components,
                                   problem.fault_materials, of_nodes);
}

template std::optional<dynamics::FaultResolution> faultResolution(Problem<2> const&,
                                                                  ParameterList const&);
template std::optional<dynamics::FaultResolution> faultResolution(Problem<3> const&,
                                                                  ParameterList const&);

std::vector<std::string> describe(dynamics::FaultResolution const& resolution)
{
  auto const& r = resolution;
  const bool one_size = r.largest_cell <= r.smallest_cell * (1 + 1e-6);
  std::vector<std::string> lines = {
    "Resolution where friction weakens: cells of " +
    (one_size ? "" : rounded(r.smallest_cell) + " to ") + rounded(r.largest_cell) +
    " m; cohesive zone G' L / (b sigma_n) >= " + rounded(r.cohesive_zone) + " m, at least " +
    rounded(r.cells_per_zone) +
    " cells; nucleation length (ageing law, Rubin & Ampuero 2005) "
    ">= " +
    rounded(r.nucleation_length) + " m."};
  if (r.cells_per_zone < enough_cells) {
    lines.push_back("WARNING: fewer than 3 cells per cohesive zone. Ruptures will depend on the "
                    "mesh; refine the fault by a factor of " +
                    rounded(enough_cells / r.cells_per_zone) + ".");
  }
  return lines;
}
} // namespace asperity::scenario
