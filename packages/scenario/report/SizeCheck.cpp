#include "scenario/report/SizeCheck.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::scenario
{
namespace
{
constexpr double diameter_of_earth = 12.742e6; // m

// Of the shortest wavelength that grows in steady slip: a layer on a rigid foundation is unstable
// if it is higher than a 2 pi-th of it. Three is for bodies that are softer than a layer.
const double smallest_body = 1 / (2 * std::acos(-1.) * 3);

constexpr char const* in_km =
  " Are the coordinates of the mesh in km? 'asperity-mesh convert --scale 1000' gives m.";
constexpr char const* in_m =
  " Are the coordinates of the mesh in m, and not multiplied with 1000 before?";
} // namespace

template <int Dim>
BodySize bodySize(Problem<Dim> const& problem, ParameterList const& deck)
{
  auto const& mesh = problem.mesh;
  std::vector<double> ends(2 * Dim, std::numeric_limits<double>::infinity()); // -highest
  for (auto const& vertex : mesh.vertices) {
    for (int d = 0; d < Dim; ++d) {
      ends[d] = std::min(ends[d], vertex[d]);
      ends[Dim + d] = std::min(ends[Dim + d], -vertex[d]);
    }
  }
  auto const diameters = mesh::cellDiameters(mesh);
  std::vector<double> times(2, std::numeric_limits<double>::infinity()); // -slowness, of cells
  for (std::size_t c = 0; c < diameters.size(); ++c) {
    auto const& rock = problem.materials[c];
    const double slowness = std::sqrt(rock.density / rock.shear_modulus);
    times[0] = std::min(times[0], -slowness);
    times[1] = std::min(times[1], diameters[c] * slowness);
  }
  ends = minOverRanks(ends, *problem.communicator);
  times = minOverRanks(times, *problem.communicator);
  BodySize size;
  double square = 0;
  for (int d = 0; d < Dim; ++d) {
    const double extent = std::max(-ends[Dim + d] - ends[d], mesh.period[d]);
    size.longest_axis = std::max(size.longest_axis, extent);
    square += extent * extent;
  }
  size.extent = std::sqrt(square);
  size.crossing_time = -times[0] * size.extent;
  size.cell_time = times[1];
  size.has_waves = !quasiDynamic(deck.sublist("Bulk"));
  auto const& time = deck.sublist("Time Stepping");
  size.smallest_step = time.isParameter("Smallest Step") ? time.get<double>("Smallest Step") : 0;
  size.final_time = finalTime(time);
  return size;
}

template BodySize bodySize(Problem<2> const&, ParameterList const&);
template BodySize bodySize(Problem<3> const&, ParameterList const&);

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
} // namespace asperity::scenario
