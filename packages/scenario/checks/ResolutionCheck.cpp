#include "scenario/checks/ResolutionCheck.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "friction/Registry.hpp"
#include "scenario/checks/Rounded.hpp"
#include "scenario/setup/mesh/GeneratedMesh.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
constexpr double enough_cells = 3;       // per cohesive zone
constexpr double cells_of_any_shape = 8; // per cohesive zone: with more, their height is harmless
constexpr double high_cell = 0.9;        // height over length; it is 1 for squares and cubes

// Two digits, as the estimate is good to a fifth.
std::string percent(double share)
{
  const double value = 100 * share;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
  return formatShort(std::round(value / unit) * unit) + " %";
}

// By how much the fault is too stiff, as a sentence; empty for so few cells that it is unknown.
std::string tooStiff(dynamics::FaultResolution const& resolution)
{
  constexpr double fewest_cells = 2; // per cohesive zone
  auto const& [along, across] = resolution.too_stiff;
  if (resolution.cells_per_zone < fewest_cells || !(along || across)) {
    return "";
  }
  return " Such bricks make it too stiff by about " +
         (along ? percent(*along) + " for slip along" : "") + (along && across ? " and " : "") +
         (across ? percent(*across) + " for slip across" : "") +
         " waves of four cohesive zones, unstructured meshes by more.";
}

std::string describeNucleation(dynamics::FaultResolution const& resolution, LawChoice const& laws)
{
  if (char const* source = laws.stateLaw().nucleation_source) {
    return "Nucleation length >= " + rounded(resolution.nucleation_length) + " m (" + source + ").";
  }
  return "Disturbances of steady slip grow if they are longer than " +
         rounded(resolution.unstable_wavelength) +
         " m (linear stability, any law); there is no formula for the nucleation length of the "
         "state law '" +
         laws.state + "'.";
}
} // namespace

std::vector<std::string> describe(dynamics::FaultResolution const& resolution,
                                  LawChoice const& laws, std::string const& lower_cells)
{
  auto const& r = resolution;
  const std::string zone = laws.frictionLaw().strength_drop
                             ? "9 pi G' d_c / (32 (mu_s - mu_d) sigma_n)"
                             : "G' L / (b sigma_n)";
  ASPERITY_REQUIRE(
    r.cells_per_zone > 0 && r.cohesive_zone > 0,
    "The cohesive zone "
      << zone
      << " of the fault is not a positive number. "
         "Check moduli, Density, Normal Stress and the parameters of friction: one is "
         "far too large or too small.");
  const bool one_size = r.largest_cell <= r.smallest_cell * (1 + 1e-6);
  std::vector<std::string> lines = {"Resolution where friction weakens: cells of " +
                                      (one_size ? "" : rounded(r.smallest_cell) + " to ") +
                                      rounded(r.largest_cell) + " m; cohesive zone " + zone +
                                      " >= " + rounded(r.cohesive_zone) + " m, at least " +
                                      rounded(r.cells_per_zone) + " cells.",
                                    describeNucleation(r, laws)};
  if (r.cells_per_zone < cells_of_any_shape && r.cell_height > high_cell) {
    lines.push_back(
      "Cells beside the fault are up to " + rounded(r.cell_height) +
      " times as high as they are long." + tooStiff(r) +
      (lower_cells.empty()
         ? ""
         : " Lower cells do better with the same nodes on the fault: 0.58 times as high as "
           "long in antiplane models, about half as high as long in others. " +
             lower_cells));
  }
  return lines;
}

std::string adviceOnLowerCells(MeshSettings const& mesh, std::vector<std::string> const& faults)
{
  if (auto const& flat = mesh.flat_cells;
      flat && std::all_of(faults.begin(), faults.end(), [&](auto const& fault) {
        return std::find(flat->begin(), flat->end(), fault) != flat->end();
      })) {
    return "";
  }
  auto const generated = generatedMesh(mesh.type);
  return generated ? generated->lower_cells : GeneratedMesh::lower_cells_beside;
}

template <int Dim>
std::optional<Warning> warnOfCellShape(Problem<Dim> const& problem)
{
  constexpr double too_high = 4;
  auto const& surface = problem.surface();
  const double height =
    surface.numGlobalNodes() > 0 ? dynamics::highestCells(problem.mesh(), surface) : 0;
  if (height <= too_high) {
    return std::nullopt;
  }
  return Warning{"shape of cells",
                 "Cells beside the fault are up to " + rounded(height) +
                   " times as high as they are long. Slip that varies along the fault by less "
                   "than their height meets far too much stiffness. Take cells that are at most as "
                   "high as long there."};
}

template std::optional<Warning> warnOfCellShape(Problem<2> const&);
template std::optional<Warning> warnOfCellShape(Problem<3> const&);

std::vector<Warning> warnOfResolution(dynamics::FaultResolution const& resolution,
                                      LawChoice const& laws)
{
  std::vector<Warning> warnings;
  if (resolution.cells_per_zone < enough_cells) {
    warnings.push_back(
      {"cohesive zone",
       "The cohesive zone has fewer than 3 cells. Ruptures will depend on the mesh; "
       "refine the fault by a factor of " +
         rounded(enough_cells / resolution.cells_per_zone) + "."});
  }
  const bool has_formula = laws.stateLaw().nucleation_source != nullptr;
  const double needed = has_formula ? resolution.nucleation_length : resolution.unstable_wavelength;
  const bool creeps_if_short = !laws.stateLaw().weakens_at_high_rates;
  if (creeps_if_short && dynamics::isTooShort(resolution, needed)) {
    warnings.push_back(
      {"nucleation length",
       std::string(has_formula ? "The nucleation length" : "The shortest length that is unstable") +
         ", " + rounded(needed) + " m, is more than twice the part of the fault that weakens, " +
         rounded(resolution.weakening_length) +
         " m: this part is likely to creep without earthquakes. Check L, a, b, Normal Stress "
         "and moduli."});
  }
  return warnings;
}

namespace
{
std::string describeFront(ExpectedFront const& front)
{
  return "At a front that slips at " + rounded(front.rate) + " m/s friction falls over a zone of " +
         rounded(front.length) + " m, " + rounded(front.cells) +
         " cells: G' / W, where W is the fall of friction with slip, by the state at the start.";
}
} // namespace

std::vector<std::string> describeScales(FaultScales const& scales)
{
  std::vector<std::string> lines;
  if (scales.barrier > 0) {
    lines.push_back("Estimates leave out " + rounded(100 * scales.barrier) +
                    " % of the fault, which cannot slip: friction there bears more than the loads "
                    "by over five times the largest stress on the fault.");
  }
  if (scales.front) {
    lines.push_back(describeFront(*scales.front));
  }
  return lines;
}

Warning warnOfFront(double cells, std::string const& where)
{
  return {"front of slip",
          "The zone over which friction falls behind a front of slip has " + rounded(cells) +
            " cells " + where + "; it needs " + formatShort(fewest_cells_of_front) +
            " or more. Otherwise cells slip one by one, and slip rates depend on the mesh; refine "
            "the fault by a factor of " +
            rounded(fewest_cells_of_front / cells) + "."};
}
} // namespace asperity::scenario
