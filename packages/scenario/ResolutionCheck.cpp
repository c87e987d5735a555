#include "scenario/ResolutionCheck.hpp"

#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "scenario/setup/LawSetup.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity::scenario
{
namespace
{
constexpr double enough_cells = 3; // per cohesive zone

struct CellSizes
{
  double smallest = std::numeric_limits<double>::max();
  double largest = 0;
};

// Estimates: three digits.
std::string rounded(double value)
{
  const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
  return formatShort(std::round(value / unit) * unit);
}

// (num_nodes) of the facets that meet at each fault node.
template <int Dim>
std::vector<CellSizes> cellSizes(Problem<Dim> const& problem)
{
  auto const& nodes = problem.fault_nodes.nodes;
  std::vector<CellSizes> sizes(nodes.size());
  for (auto const& facet : problem.mesh.boundaries.at(problem.boundary.fault)) {
    const double measure = mesh::facetMeasure(mesh::corners(problem.mesh, facet));
    const double size = Dim == 2 ? measure : std::sqrt(2 * measure);
    for (int node : facet) {
      auto const place = std::lower_bound(nodes.begin(), nodes.end(), node);
      if (place != nodes.end() && *place == node) {
        auto& at_node = sizes[place - nodes.begin()];
        at_node.smallest = std::min(at_node.smallest, size);
        at_node.largest = std::max(at_node.largest, size);
      }
    }
  }
  return sizes;
}
} // namespace

double slipModulus(fem::Material const& material, int components, bool antisymmetric)
{
  const double G = material.shear_modulus;
  if (components != 2) {
    return antisymmetric ? G : 2 * G;
  }
  const double nu = material.poissonsRatio();
  return antisymmetric ? G / (1 - nu) : 8 * G * (1 - nu) / (3 - 4 * nu);
}

double cohesiveZone(double slip_modulus, double b, double L, double sigma_n)
{
  return slip_modulus * L / (b * sigma_n);
}

double nucleationLength(double slip_modulus, double a, double b, double L, double sigma_n)
{
  const double weakening = 1 - a / b;
  const double half = std::max(1.3774, 1 / (M_PI * weakening * weakening)); // in units of Lambda0
  return 2 * half * cohesiveZone(slip_modulus, b, L, sigma_n);
}

template <int Dim>
std::optional<FaultResolution> faultResolution(Problem<Dim> const& problem,
                                               ParameterList const& friction)
{
  auto const& nodes = problem.fault_nodes.nodes;
  auto const sensitivity = sensitivities(friction, problem.mesh, nodes);
  auto const slip_distance = slipDistances(friction, problem.mesh, nodes);
  if (!sensitivity || !slip_distance) {
    return std::nullopt;
  }
  auto const sigma_n =
    Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), problem.fault.data.sigma_n);
  auto const sizes = cellSizes(problem);
  // Smallest of all, the largest cell with the opposite sign.
  std::array<double, 5> mine;
  mine.fill(std::numeric_limits<double>::max());
  for (int i = 0; i < problem.fault.numNodes(); ++i) {
    auto const [a, b] = (*sensitivity)[i];
    const double L = (*slip_distance)[i];
    if (!(b > a) || !(sigma_n(i) > 0)) {
      continue;
    }
    const double modulus =
      slipModulus(problem.fault_materials[i], problem.components, problem.boundary.antisymmetric);
    const double zone = cohesiveZone(modulus, b, L, sigma_n(i));
    const std::array<double, 5> here = {sizes[i].smallest, -sizes[i].largest, zone,
                                        nucleationLength(modulus, a, b, L, sigma_n(i)),
                                        zone / sizes[i].largest};
    std::transform(here.begin(), here.end(), mine.begin(), mine.begin(),
                   [](double x, double y) { return std::min(x, y); });
  }
  auto all = mine;
  Teuchos::reduceAll(*problem.communicator, Teuchos::REDUCE_MIN, static_cast<int>(mine.size()),
                     mine.data(), all.data());
  if (all[1] > 0) {
    return std::nullopt;
  }
  return FaultResolution{all[0], -all[1], all[2], all[3], all[4]};
}

template std::optional<FaultResolution> faultResolution(Problem<2> const&, ParameterList const&);
template std::optional<FaultResolution> faultResolution(Problem<3> const&, ParameterList const&);

std::vector<std::string> describe(FaultResolution const& resolution)
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
