#include "scenario/checks/SmallestStep.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "dynamics/control/PrescribedSteps.hpp"
#include "scenario/checks/ShearWaves.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
constexpr char const* step_name = time_entries::smallest_step;

double defaultStep(dynamics::FaultResolution const& resolution, BulkSettings const& bulk,
                   TimeSettings const& time)
{
  const double seismic = dynamics::seismicStep(resolution, !bulk.isQuasiDynamic());
  return std::min(seismic, time.largest_step / 2);
}

// The default where no state of the fault decides on steps (Fault::stateDecides), so that there are
// no earthquakes to resolve: a millionth of the run, to which the times are met at which slip or a
// load begins.
template <int Dim>
double defaultWithoutState(Problem<Dim> const& problem)
{
  constexpr double share_of_run = 1e-6, share_of_crossing = 0.1;
  auto const& time = problem.settings.time;
  const double largest = time.largest_step;
  const double of_run = share_of_run * std::min(time.final_time, largest);
  return problem.settings.bulk.isQuasiDynamic()
           ? of_run
           : std::min(
               {of_run, share_of_crossing * shearWavesOf(problem).through_cell, largest / 2});
}

template <int Dim>
double stepOfDeckOrDefault(Problem<Dim> const& problem)
{
  if (auto const given = problem.settings.time.smallest_step) {
    return *given;
  }
  if (!problem.model.fault.stateDecides()) {
    return defaultWithoutState(problem);
  }
  ASPERITY_REQUIRE(problem.scales.resolution,
                   time_path << " / " << step_name
                             << " is missing. It has a default only if friction weakens "
                                "somewhere that can slip and its laws declare a, b and L. "
                                "Give a step that resolves the fastest slip.");
  return defaultStep(*problem.scales.resolution, problem.settings.bulk, problem.settings.time);
}

// Such rock is a fluid in any step, and its shear modulus a number without effect.
constexpr double far_below = 1e-3; // relaxation time over the smallest step
} // namespace

template <int Dim>
double smallestStep(Problem<Dim> const& problem)
{
  const double step = stepOfDeckOrDefault(problem);
  for (auto const& branch : problem.discretisation.rock.branches) {
    ASPERITY_REQUIRE(branch.time >= far_below * step,
                     bulk_path << ": a relaxation time, " << branch.time
                               << " s, is less than a thousandth of the smallest step, " << step
                               << " s. Check the viscosity, whose unit is Pa s, and the shear "
                                  "modulus; or choose a smaller '"
                               << step_name << "'.");
  }
  return step;
}

namespace
{
double shortestPrescribed(TimeSettings const& time) // [s], 0 if no size is named
{
  auto const levels = dynamics::PrescribedSteps::levelsIn(time.control_list);
  auto const finest = std::max_element(levels.begin(), levels.end());
  return finest == levels.end() ? 0 : std::ldexp(time.largest_step, -*finest);
}
} // namespace

template <int Dim>
void describeSmallestStep(Problem<Dim> const& problem, Description& description)
{
  auto const& time = problem.settings.time;
  auto const& resolution = problem.scales.resolution;
  if (!problem.model.fault.stateDecides() && !time.smallest_step) {
    description.lines.push_back(step_name + (" = " + formatShort(smallestStep(problem))) +
                                " s by default, since no state of the fault decides on steps.");
  }
  if (!resolution) {
    return;
  }
  const double seismic = resolution->seismic_time,
               advised = defaultStep(*resolution, problem.settings.bulk, problem.settings.time);
  if (time.control == "Prescribed") {
    const double shortest = shortestPrescribed(time);
    if (shortest > seismic) {
      description.warnings.push_back(
        {"smallest step", "The shortest prescribed step, " + formatShort(shortest) +
                            " s, is longer than an earthquake takes to slip by L, " +
                            formatShort(seismic) +
                            " s: earthquakes may be lost. Choose another 'Control', or steps of " +
                            formatShort(advised) + " s or less."});
    }
  } else if (!time.smallest_step) {
    description.lines.push_back(
      step_name + (" = " + formatShort(advised)) + " s by default: an earthquake slips by L in " +
      formatShort(seismic) + " s or more; a shear wave takes " +
      formatShort(resolution->crossing_time) + " s through a cell at the fault.");
  } else if (*time.smallest_step > seismic) {
    description.warnings.push_back(
      {"smallest step", step_name + (" = " + formatShort(*time.smallest_step)) +
                          " s is longer than an earthquake takes to slip by L, " +
                          formatShort(seismic) +
                          " s: earthquakes may be lost. Leave it out for the default of " +
                          formatShort(advised) + " s, or choose a smaller one."});
  }
}

template double smallestStep(Problem<2> const&);
template double smallestStep(Problem<3> const&);
template void describeSmallestStep(Problem<2> const&, Description&);
template void describeSmallestStep(Problem<3> const&, Description&);
} // namespace asperity::scenario
