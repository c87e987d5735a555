#include "scenario/report/RunReport.hpp"

#include "base/Text.hpp"
#include "scenario/checks/DriveCheck.hpp"
#include "scenario/checks/FlatCellCheck.hpp"
#include "scenario/checks/HeldSlip.hpp"
#include "scenario/checks/ResolutionCheck.hpp"
#include "scenario/checks/SizeCheck.hpp"
#include "scenario/checks/SmallestStep.hpp"
#include "scenario/checks/ToleranceCheck.hpp"
#include "scenario/problem/Upright.hpp"
#include "scenario/report/Environment.hpp"
#include "scenario/report/FaultDescription.hpp"
#include "scenario/report/ModelSize.hpp"
#include "scenario/setup/friction/LawSetup.hpp"
#include "scenario/setup/mesh/GeneratedMesh.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace asperity::scenario
{
namespace
{
// For a generated wedge: what its cell size means, and a warning if gravity is not perpendicular to
// the surface.
void describeWedge(MeshSettings const& mesh, BulkSettings const& bulk,
                   std::array<double, 3> const& downwards, Description& description)
{
  auto const generated = generatedMesh(mesh.type);
  if (!generated || !generated->wedge_shape) {
    return;
  }
  auto const wedge = generated->wedge_shape(mesh.shape);
  description.lines.push_back(
    "Cell Size = " + formatShort(wedge.cell_size) +
    " m is the largest diameter of cells at the seismogenic zone. They are bisected until none is "
    "larger, so that some may be half as large.");
  const double slope = wedge.height / wedge.length;
  auto const down =
    bulk.gravity_direction.value_or(std::vector<double>(downwards.begin(), downwards.end()));
  if (bulk.hasGravity() &&
      !(std::abs(down[0] + slope * down[1]) <= 1e-6 * std::hypot(down[0], down[1]))) {
    description.warnings.push_back(
      {"direction of gravity",
       "Gravity Direction = {" + formatShort(down[0]) + ", " + formatShort(down[1]) +
         "} is not perpendicular to the surface of the wedge. With Height / Length = " +
         formatShort(slope) + " it would be {" + formatShort(slope) + ", -1}."});
  }
}

bool hasWarning(std::string const& topic, std::vector<Warning> const& warnings)
{
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](Warning const& warning) { return warning.topic == topic; });
}

// What the run computes: the body, friction, the time scheme, and what is prescribed.
template <int Dim>
void describeModel(Problem<Dim> const& problem, Description& description)
{
  auto& lines = description.lines;
  std::ostringstream first;
  auto const& bulk = problem.settings.bulk;
  first << bulk.model() << ", " << (bulk.isQuasiDynamic() ? "quasi-dynamic, " : "inertial, ")
        << problem.mesh().num_global_vertices << " vertices, "
        << (problem.surface().numGlobalNodes() > 0
              ? std::to_string(problem.surface().numGlobalNodes()) + " of them on the fault '" +
                  problem.surface().name() + "'."
              : "no fault.");
  lines.push_back(first.str());
  auto const& laws = problem.settings.friction.laws;
  auto const& time = problem.settings.time;
  lines.push_back(
    (laws.hasFrictionLaw() ? laws.friction + " friction, state evolution: " + laws.state
                           : std::string("No friction")) +
    ". Time stepping: " + time.scheme + ", " + time.control + ". Linear correction: " +
    (problem.solver.correction == dynamics::Correction::direct ? "Direct." : "Multigrid."));
  if (!problem.discretisation.boundary.given_slip.empty()) {
    lines.push_back(
      "The slip rate is prescribed on " + quotedNames(problem.discretisation.boundary.given_slip) +
      (problem.surface().numSliding() > 0 ? "." : ", hence everywhere: friction acts nowhere."));
  }
  if (!problem.discretisation.rock.branches.empty()) {
    std::string times;
    for (auto const& branch : problem.discretisation.rock.branches) {
      times += (times.empty() ? "" : ", ") + formatShort(branch.time);
    }
    lines.push_back("Shear stress in the rock relaxes within " + times + " s.");
  }
}
} // namespace

template <int Dim>
Description describe(Problem<Dim> const& problem)
{
  DeckSettings const& settings = problem.settings;
  Description description{describeEnvironment(*problem.communicator), problem.findings.warnings};
  describeModel(problem, description);
  description.add(describeSize(problem));
  describeWedge(settings.mesh, settings.bulk, problem.discretisation.upright.down, description);
  description.add(describeSense(problem));
  if (auto const of_shape = warnOfCellShape(problem)) {
    description.warnings.push_back(*of_shape);
  }
  description.add(problem.findings.remarks);
  if (auto const& resolution = problem.scales.resolution) {
    auto const& laws = settings.friction.laws;
    description.add(describe(
      *resolution, laws,
      adviceOnLowerCells(settings.mesh, faultsWithFriction(problem.discretisation.boundary))));
    description.add(warnOfResolution(*resolution, laws));
  }
  // With a normal stress in the wrong unit the lengths of friction are wrong, not the body's.
  description.add(warnOfSize(bodySize(problem), hasWarning("normal stress", description.warnings)
                                                  ? std::nullopt
                                                  : problem.scales.resolution));
  describeHeldSlip(problem, description);
  description.add(warnOfDrive(problem));
  description.add(warnOfPrescribedSlip(problem));
  description.add(describeScales(problem.scales));
  auto const& front = problem.scales.front;
  if (problem.scales.zone && front && front->cells < fewest_cells_of_front) {
    description.warnings.push_back(warnOfFront(front->cells, "at " + formatShort(front->rate) +
                                                               " m/s, as expected at the start"));
  }
  describeSmallestStep(problem, description);
  description.add(warnOfFlatCells(problem));
  description.add(warnOfTolerances(settings.time, settings.coupling));
  return description;
}

template Description describe(Problem<2> const&);
template Description describe(Problem<3> const&);
} // namespace asperity::scenario
