#include "dynamics/checks/FaultResolution.hpp"

#include "base/parallel/Reductions.hpp"
#include "fem/BoundaryCells.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
// (num_nodes) sizes of the facets that meet at each fault node, and of the cells beside them.
template <int Dim>
std::vector<CellSizes> cellSizes(Mesh<Dim> const& mesh, fem::FaultSurface const& surface)
{
  std::vector<CellSizes> sizes(surface.numNodes());
  auto const& facets = mesh.boundaries.at(surface.name());
  auto const cells = fem::cellsBeside(mesh, surface.name());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    auto const& facet = facets[i];
    const double measure = mesh::facetMeasure(mesh::corners(mesh, facet));
    const double size = Dim == 2 ? measure : std::sqrt(2 * measure);
    const double volume = mesh::signedMeasure(mesh::corners(mesh, mesh.cells[cells[i]]));
    const double height = Dim * std::abs(volume) / measure / size;
    for (int vertex : facet) {
      if (const int node = surface.nodeAt(vertex); node >= 0) {
        auto& at_node = sizes[node];
        at_node.smallest = std::min(at_node.smallest, size);
        at_node.largest = std::max(at_node.largest, size);
        at_node.height = std::max(at_node.height, height);
      }
    }
  }
  return sizes;
}

// [m/s], see FaultResolution::seismic_time; 1 m/s for a body without density. stress_drop in Pa.
double seismicRate(fem::Material const& material, fem::OtherSide const& other_side,
                   double stress_drop)
{
  const double impedance = material.shearImpedance() / other_side.deforming_sides;
  return impedance > 0 ? stress_drop / impedance : 1;
}

double crossingTime(fem::Material const& material, double length)
{
  return length * std::sqrt(material.density / material.shear_modulus);
}
} // namespace

double slipModulus(fem::Material const& material, int components, fem::OtherSide const& other_side)
{
  const bool is_shared = other_side.deforming_sides == 2;
  const double G = material.shear_modulus;
  if (components != 2) {
    return is_shared ? G : 2 * G;
  }
  const double nu = material.poissonsRatio();
  return is_shared ? G / (1 - nu) : 8 * G * (1 - nu) / (3 - 4 * nu);
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

double unstableWavelength(double slip_modulus, double a, double b, double L, double sigma_n)
{
  return M_PI * slip_modulus * L / ((b - a) * sigma_n);
}

double slipWeakeningZone(double slip_modulus, double drop, double distance, double sigma_n)
{
  return 9 * M_PI / 32 * slip_modulus * distance / (drop * sigma_n);
}

double slipWeakeningLength(double slip_modulus, double drop, double distance, double sigma_n)
{
  return 1.158 * slip_modulus * distance / (drop * sigma_n);
}

namespace
{
struct Weakening
{
  double zone, nucleation, wavelength; // [m]
  double stress_drop;                  // [Pa]
};

// At a node; empty where friction does not weaken.
std::optional<Weakening> weakeningAt(int node, FrictionOfNodes const& friction, double modulus)
{
  auto const& [a, b, L, sigma_n, drop, can_slip] = friction;
  const double sigma = sigma_n[node], distance = L[node];
  if (!friction.canSlip(node) || !(sigma > 0) ||
      !(drop.empty() ? b[node] > a[node] : drop[node] > 0)) {
    return std::nullopt;
  }
  if (drop.empty()) {
    return Weakening{cohesiveZone(modulus, b[node], distance, sigma),
                     nucleationLength(modulus, a[node], b[node], distance, sigma),
                     unstableWavelength(modulus, a[node], b[node], distance, sigma),
                     20 * b[node] * sigma};
  }
  const double nucleation = slipWeakeningLength(modulus, drop[node], distance, sigma);
  return Weakening{slipWeakeningZone(modulus, drop[node], distance, sigma), nucleation, nucleation,
                   drop[node] * sigma};
}

// The extremes that FaultResolution has of values at nodes.
constexpr std::array smallest_of_nodes = {
  &FaultResolution::smallest_cell,     &FaultResolution::cohesive_zone,
  &FaultResolution::nucleation_length, &FaultResolution::unstable_wavelength,
  &FaultResolution::cells_per_zone,    &FaultResolution::slip_distance,
  &FaultResolution::seismic_time,      &FaultResolution::crossing_time};
constexpr std::array largest_of_nodes = {&FaultResolution::largest_cell,
                                         &FaultResolution::cell_height};

// Of no node.
FaultResolution noExtremes()
{
  FaultResolution result{};
  for (auto const member : smallest_of_nodes) {
    result.*member = std::numeric_limits<double>::max();
  }
  for (auto const member : largest_of_nodes) {
    result.*member = std::numeric_limits<double>::lowest();
  }
  return result;
}

void include(FaultResolution const& node, FaultResolution& extremes)
{
  for (auto const member : smallest_of_nodes) {
    extremes.*member = std::min(node.*member, extremes.*member);
  }
  for (auto const member : largest_of_nodes) {
    extremes.*member = std::max(node.*member, extremes.*member);
  }
}

FaultResolution overRanks(FaultResolution extremes, Communicator const& communicator)
{
  std::array<double, smallest_of_nodes.size()> smallest;
  std::array<double, largest_of_nodes.size()> largest;
  for (std::size_t i = 0; i < smallest.size(); ++i) {
    smallest[i] = extremes.*smallest_of_nodes[i];
  }
  for (std::size_t i = 0; i < largest.size(); ++i) {
    largest[i] = extremes.*largest_of_nodes[i];
  }
  smallest = minOverRanks(smallest, communicator);
  largest = maxOverRanks(largest, communicator);
  for (std::size_t i = 0; i < smallest.size(); ++i) {
    extremes.*smallest_of_nodes[i] = smallest[i];
  }
  for (std::size_t i = 0; i < largest.size(); ++i) {
    extremes.*largest_of_nodes[i] = largest[i];
  }
  return extremes;
}

// The values at a place that weakens.
FaultResolution resolutionAt(int place, FaultPlaces const& places, fem::Material const& material,
                             FrictionOfNodes const& friction, Weakening const& weakening)
{
  auto const& cells = places.cells[place];
  const double L = friction.L[place];
  FaultResolution result{};
  result.smallest_cell = cells.smallest;
  result.largest_cell = cells.largest;
  result.cohesive_zone = weakening.zone;
  result.nucleation_length = weakening.nucleation;
  result.unstable_wavelength = weakening.wavelength;
  result.cells_per_zone = weakening.zone / cells.largest;
  result.cell_height = cells.height;
  result.slip_distance = L;
  result.seismic_time = L / seismicRate(material, places.other_side, weakening.stress_drop);
  result.crossing_time = crossingTime(material, cells.smallest);
  return result;
}
} // namespace

std::vector<bool> canSlip(std::vector<double> const& strength, std::vector<double> const& driving,
                          std::vector<double> const& sigma_n, Communicator const& communicator)
{
  constexpr double beyond_reach = 5; // times the largest stress
  double largest = 0;
  for (std::size_t node = 0; node < strength.size(); ++node) {
    largest = std::max({largest, driving[node], sigma_n[node]});
  }
  largest = maxOverRanks(largest, communicator);
  std::vector<bool> result(strength.size());
  for (std::size_t node = 0; node < strength.size(); ++node) {
    result[node] = !(strength[node] - driving[node] > beyond_reach * largest);
  }
  return result;
}

template <int Dim>
double highestCells(Mesh<Dim> const& mesh, fem::FaultSurface const& surface)
{
  auto const sizes = cellSizes(mesh, surface);
  double weight = 0;
  for (int node = 0; node < surface.numNodes(); ++node) {
    weight += surface[node].weight;
  }
  auto const& comm = *surface.communicator();
  const double measure = sumOverRanks(weight, comm);
  const double extent = Dim == 2 ? measure : std::sqrt(measure);
  constexpr double few_facets = 5;
  double highest = 0;
  for (auto const& at_node : sizes) {
    if (few_facets * at_node.largest < extent) {
      highest = std::max(highest, at_node.height);
    }
  }
  return maxOverRanks(highest, comm);
}

template <int Dim>
std::vector<double> largerCells(Mesh<Dim> const& mesh, fem::FaultSurface const& surface)
{
  std::vector<double> result;
  for (auto const& sizes : cellSizes(mesh, surface)) {
    result.push_back(sizes.largest);
  }
  return result;
}

std::vector<double> rateWeakeningDistances(FrictionOfNodes const& friction)
{
  std::vector<double> distances(friction.L.size(), 0);
  for (std::size_t node = 0; friction.drop.empty() && node < distances.size(); ++node) {
    const bool weakens = friction.canSlip(static_cast<int>(node)) && friction.sigma_n[node] > 0 &&
                         friction.b[node] > friction.a[node];
    distances[node] = weakens ? friction.L[node] : 0;
  }
  return distances;
}

StiffnessError stiffnessError(int components, double height, double cells)
{
  const double kh = 2 * M_PI / cells, square = height * height;
  StiffnessError error;
  if (components > 1) {
    error.along = kh * kh * (components == 3 ? 0.02 + 0.34 * square : 0.04 + 0.47 * square);
  }
  if (components != 2) {
    error.across = kh * kh * (square / 8 - 1 / 24.);
  }
  return error;
}

bool isTooShort(FaultResolution const& resolution, double needed)
{
  return !resolution.weakens_everywhere && needed > 2 * resolution.weakening_length;
}

double seismicStep(FaultResolution const& resolution, bool has_mass)
{
  const double of_slip = 0.01 * resolution.seismic_time;
  return has_mass ? std::min(of_slip, 0.1 * resolution.crossing_time) : of_slip;
}

std::optional<FaultResolution> faultResolution(FaultPlaces const& places, int components,
                                               std::vector<fem::Material> const& materials,
                                               FrictionOfNodes const& friction,
                                               Communicator const& communicator)
{
  FaultResolution mine = noExtremes();
  double measure = 0; // of what weakens
  bool weakens_everywhere = true;
  for (std::size_t i = 0; i < places.cells.size(); ++i) {
    const int place = static_cast<int>(i);
    const double modulus = slipModulus(materials[i], components, places.other_side);
    auto const weakening = weakeningAt(place, friction, modulus);
    if (!weakening) {
      weakens_everywhere = false;
      continue;
    }
    measure += places.weights[i];
    include(resolutionAt(place, places, materials[i], friction, *weakening), mine);
  }
  auto result = overRanks(mine, communicator);
  if (result.largest_cell < 0) { // no node weakens
    return std::nullopt;
  }
  measure = sumOverRanks(measure, communicator);
  result.too_stiff = stiffnessError(components, result.cell_height, 4 * result.cells_per_zone);
  result.weakening_length = places.dimension == 2 ? measure : std::sqrt(measure);
  result.weakens_everywhere = minOverRanks(weakens_everywhere ? 1 : 0, communicator) == 1;
  return result;
}

template <int Dim>
std::optional<FaultResolution>
faultResolution(Mesh<Dim> const& mesh, fem::FaultSurface const& surface, int components,
                std::vector<fem::Material> const& materials, FrictionOfNodes const& friction)
{
  FaultPlaces nodes{Dim, surface.otherSide(), cellSizes(mesh, surface), {}};
  for (int i = 0; i < surface.numNodes(); ++i) {
    nodes.weights.push_back(surface[i].weight);
  }
  return faultResolution(nodes, components, materials, friction, *surface.communicator());
}

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template std::vector<double> largerCells(Mesh<DIM> const&, fem::FaultSurface const&);            \
  template double highestCells(Mesh<DIM> const&, fem::FaultSurface const&);                        \
  template std::optional<FaultResolution> faultResolution(                                         \
    Mesh<DIM> const&, fem::FaultSurface const&, int, std::vector<fem::Material> const&,            \
    FrictionOfNodes const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::dynamics
