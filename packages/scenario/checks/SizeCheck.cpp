#include "scenario/checks/SizeCheck.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/BoundingBox.hpp"
#include "mesh/Mesh.hpp"
#include "mesh/MeshQuality.hpp"
#include "scenario/checks/BoundaryField.hpp"
#include "scenario/checks/ShearWaves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace asperity::scenario
{
namespace
{
constexpr double diameter_of_earth = 12.742e6; // m

// The height of the smallest unstable body, divided by the shortest wavelength that grows in steady
// slip: a layer on a rigid foundation is unstable if it is higher than that wavelength over 2 pi.
// The factor three allows for bodies that are softer than a layer.
const double smallest_body = 1 / (2 * std::acos(-1.) * 3);

constexpr char const* in_km =
  " Are the coordinates of the mesh in km? 'asperity-mesh convert --scale 1000' gives m.";
constexpr char const* in_m =
  " Are the coordinates of the mesh in m, or has something multiplied them by 1000?";
} // namespace

template <int Dim>
BodySize bodySize(Problem<Dim> const& problem)
{
  auto const& mesh = problem.mesh();
  auto const sides = mesh::sidesOfBox<Dim>(mesh.vertices, *problem.communicator);
  auto const waves = shearWavesOf(problem);
  BodySize size;
  double square = 0;
  for (int d = 0; d < Dim; ++d) {
    const double extent = std::max(sides[d], mesh.period[d]);
    size.longest_axis = std::max(size.longest_axis, extent);
    square += extent * extent;
  }
  size.extent = std::sqrt(square);
  size.crossing_time = waves.slowness * size.extent;
  size.cell_time = waves.through_cell;
  size.has_waves = !problem.settings.bulk.isQuasiDynamic();
  auto const& time = problem.settings.time;
  size.smallest_step = time.smallest_step.value_or(0);
  size.final_time = time.final_time;
  return size;
}

template BodySize bodySize(Problem<2> const&);
template BodySize bodySize(Problem<3> const&);

std::vector<Warning> warnOfSize(BodySize const& size,
                                std::optional<dynamics::FaultResolution> const& resolution)
{
  std::vector<Warning> warnings;
  const auto body = [&](std::string const& text) {
    warnings.push_back({"size of the body", text});
  };
  if (size.longest_axis > diameter_of_earth) {
    body("The body is " + formatShort(size.longest_axis / 1000) + " km long, more than the earth." +
         in_m);
  } else if (size.has_waves && size.cell_time > size.final_time) {
    body("A shear wave takes " + formatShort(size.cell_time) +
         " s through the smallest cell, and the run ends after " + formatShort(size.final_time) +
         " s: no wave arrives anywhere." + in_m);
  } else if (size.smallest_step > size.crossing_time) {
    body("A shear wave takes " + formatShort(size.crossing_time) +
         " s through the whole body, which is " + formatShort(size.extent) +
         " m large, and the smallest step is " + formatShort(size.smallest_step) +
         " s: ruptures are over within one." + in_km);
  } else if (resolution && resolution->unstable_wavelength * smallest_body > size.extent) {
    body("The body is " + formatShort(size.extent) +
         " m large, and slip is unstable on lengths of " +
         formatShort(resolution->unstable_wavelength) +
         " m and more: it creeps, and there are no earthquakes." + in_km);
  }
  if (resolution && resolution->smallest_cell < resolution->slip_distance) {
    warnings.push_back({"size of cells", "Cells at the fault are " +
                                           formatShort(resolution->smallest_cell) +
                                           " m long, shorter than the slip distance of friction, " +
                                           formatShort(resolution->slip_distance) +
                                           " m: strains are not small." + in_km});
  }
  return warnings;
}

namespace
{
// The largest slip is computed with both numbers of times, and the smaller result counts: a short
// pulse that one set of times meets by chance is missed by the other one.
constexpr int numbers_of_times[] = {128, 101};

// The largest slip at nodes that the rate prescribes from t = 0 to `end`.
double largestSlip(NodalField const& rate, double end)
{
  double smaller = std::numeric_limits<double>::infinity();
  for (const int times : rate.dependsOnTime()
                           ? std::vector<int>(numbers_of_times, std::end(numbers_of_times))
                           : std::vector<int>{1}) {
    std::vector<double> slip;
    for (int i = 0; i < times; ++i) {
      auto const rates = rate.at((i + 0.5) / times * end);
      slip.resize(rates.size(), 0.);
      for (std::size_t node = 0; node < rates.size(); ++node) {
        slip[node] += rates[node] * end / times;
      }
    }
    double largest = 0;
    for (const double value : slip) {
      largest = std::max(largest, std::abs(value));
    }
    smaller = std::min(smaller, largest);
  }
  return smaller;
}
} // namespace

template <int Dim>
std::vector<Warning> warnOfPrescribedSlip(Problem<Dim> const& problem)
{
  constexpr double small_strain = 0.05;
  const double end = problem.settings.time.final_time;
  auto const& names = problem.discretisation.boundary.given_slip;
  for (auto const& condition : problem.settings.conditions) {
    auto const& name = condition.boundary;
    if (std::find(names.begin(), names.end(), name) == names.end() || !condition.givesSlipRate()) {
      continue;
    }
    std::vector<Point<Dim>> places;
    for (const int vertex : mesh::boundaryVertices(problem.mesh(), name)) {
      places.push_back(problem.mesh().vertices[vertex]);
    }
    auto const sides = mesh::sidesOfBox<Dim>(places, *problem.communicator);
    const double extent = *std::max_element(sides.begin(), sides.end());
    auto const rate = boundaryField(condition, condition_entries::slip_rate, problem.mesh());
    const double slip = maxOverRanks(largestSlip(rate, end), *problem.communicator);
    if (slip > small_strain * extent) {
      return {
        {"prescribed slip", "The slip prescribed on '" + name + "', " + formatShort(slip) +
                              " m until the end of the run, is more than 5 % of its length, " +
                              formatShort(extent) + " m: strains are not small." + in_km}};
    }
  }
  return {};
}

template std::vector<Warning> warnOfPrescribedSlip(Problem<2> const&);
template std::vector<Warning> warnOfPrescribedSlip(Problem<3> const&);
} // namespace asperity::scenario
