#include "scenario/report/RunReport.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"
#include "scenario/checks/DriveCheck.hpp"
#include "scenario/checks/HeldSlip.hpp"
#include "scenario/checks/ResolutionCheck.hpp"
#include "scenario/checks/SizeCheck.hpp"
#include "scenario/checks/SmallestStep.hpp"
#include "scenario/problem/Upright.hpp"
#include "scenario/report/Environment.hpp"
#include "scenario/report/FaultSense.hpp"
#include "scenario/report/ModelSize.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/friction/LawSetup.hpp"
#include "scenario/setup/mesh/GeneratedMesh.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"
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
void describeWedge(ParameterList const& mesh, BulkSettings const& bulk,
                   std::array<double, 3> const& downwards, Description& description)
{
  auto const type = mesh.get<std::string>("Type");
  auto const generated = generatedMesh(type);
  if (!generated || !generated->is_wedge) {
    return;
  }
  auto const& wedge = mesh.sublist(type);
  description.lines.push_back(
    "Cell Size = " + formatShort(wedge.get<double>("Cell Size")) +
    " m is the largest diameter of cells at the seismogenic zone. They are bisected until none is "
    "larger, so that some may be half as large.");
  const double slope = wedge.get<double>("Height") / wedge.get<double>("Length");
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

void warnOfCoupling(double given, double of_steps, Description& description)
{
  if (of_steps > 0 && given > of_steps) {
    description.warnings.push_back(
      {"coupling tolerance",
       "Coupling / Tolerance = " + formatShort(given) +
         " is above the Tolerance = " + formatShort(of_steps) +
         " of the step control: the errors that it leaves add up over many steps, and intervals "
         "between events change. Leave it out: the default is a thousandth."});
  }
}

void warnOfTolerance(TimeSettings const& time, Description& description)
{
  // Twice what decks in space have. With backward Euler and a tolerance of 0.03 the first event of
  // spring_slider.xml comes after 59 s; the exact time is 345 s.
  constexpr double loose = 0.02;
  if (time.tolerance > loose) {
    description.warnings.push_back(
      {"loose tolerance",
       "Time Stepping / " + time.control + " / " + time.tolerance_entry + " = " +
         formatShort(time.tolerance) + " is looser than " + formatShort(loose) +
         ": numbers and times of earthquakes may be wrong. Decks have 1e-5 to 1e-2; asperity-study "
         "--convergence shows the effect of a tolerance."});
  }
}

// Whether a boundary has a tip, on any rank.
template <int Dim>
bool hasTip(Problem<Dim> const& problem, std::string const& boundary)
{
  auto const vertices = mesh::boundaryVertices(problem.mesh(), boundary);
  auto const& pairs = problem.mesh().splits;
  const bool here = std::any_of(pairs.begin(), pairs.end(), [&](SplitVertex const& pair) {
    return pair.is_tip && std::binary_search(vertices.begin(), vertices.end(), pair.plus);
  });
  return maxOverRanks(here ? 1 : 0, *problem.communicator) == 1;
}

bool hasWarning(std::string const& topic, std::vector<Warning> const& warnings)
{
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](Warning const& warning) { return warning.topic == topic; });
}

// Where slip is prescribed, the stiffness of the fault has no effect.
template <int Dim>
void warnOfFlatCells(Problem<Dim> const& problem, Description& description)
{
  ParameterList const& mesh = problem.settings.lists.mesh;
  if (!mesh.isParameter(flat_cells_beside)) {
    return;
  }
  auto const names = mesh.get<Teuchos::Array<std::string>>(flat_cells_beside);
  for (auto const& condition : problem.settings.conditions) {
    auto const& name = condition.boundary;
    if (condition.type->isContinuation() &&
        std::find(names.begin(), names.end(), name) != names.end() && hasTip(problem, name)) {
      description.warnings.push_back(
        {"flat cells",
         std::string("Mesh / ") + flat_cells_beside + " names '" + name +
           "', along which slip is prescribed and ends inside the body. Flat cells give "
           "friction the right stiffness, but do not improve the response of the body to "
           "prescribed slip: within two cells of its ends displacements err by 10 to 30 %, and "
           "move with the vertices. Leave '" +
           name + "' out, and take smaller cells there."});
    }
  }
}

// What the run computes: the body, friction, the time scheme, and what is prescribed.
template <int Dim>
void describeModel(Problem<Dim> const& problem, Description& description)
{
  auto& lines = description.lines;
  std::ostringstream first;
  ParameterList const& bulk = problem.settings.lists.bulk;
  first << bulk.get<std::string>("Model") << ", "
        << (problem.settings.bulk.isQuasiDynamic() ? "quasi-dynamic, " : "inertial, ")
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
  describeWedge(settings.lists.mesh, settings.bulk, problem.discretisation.upright.down,
                description);
  description.add(describeSense(problem));
  if (auto const of_shape = warnOfCellShape(problem)) {
    description.warnings.push_back(*of_shape);
  }
  description.add(problem.findings.remarks);
  if (auto const& resolution = problem.scales.resolution) {
    auto const& laws = settings.friction.laws;
    description.add(
      describe(*resolution, laws,
               adviceOnLowerCells(settings.lists.mesh,
                                  faultsWithFriction(problem.discretisation.boundary))));
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
  warnOfFlatCells(problem, description);
  warnOfTolerance(settings.time, description);
  warnOfCoupling(settings.coupling.tolerance, settings.time.tolerance, description);
  return description;
}

template Description describe(Problem<2> const&);
template Description describe(Problem<3> const&);
} // namespace asperity::scenario
