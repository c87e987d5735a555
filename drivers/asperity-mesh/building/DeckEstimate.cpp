#include "building/DeckEstimate.hpp"

#include "Warnings.hpp"
#include "building/BuildReport.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "dynamics/checks/FaultResolution.hpp"
#include "friction/Registry.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/report/ResolutionCheck.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/friction/LawSetup.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "scenario/setup/rock/RockSetup.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <ostream>

namespace asperity::geometry
{
namespace
{
constexpr double step_seconds = 2.7e-6; // of one core for an unknown, docs/cost/cost.md
constexpr int components = 3;

Samples samplesOf(std::vector<std::string> const& faults, Complex const& complex,
                  Model const& model, CellSize const& size)
{
  Samples samples;
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    const int s = complex.surfaces[i];
    if (model.isFault(s) && std::count(faults.begin(), faults.end(), model.name(s)) > 0) {
      addSamples(samples, complex, complex.triangles[i], size);
    }
  }
  return samples;
}

// A body of one region, in a cell of which each place lies.
Mesh<3> bodyOfOneRegion()
{
  Mesh<3> body;
  body.region_names = {"body"};
  body.cell_regions = {0};
  body.cells = {{0, 1, 2, 3}};
  body.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return body;
}

scenario::FieldNodes nodesAt(std::vector<std::array<double, 3>> const& places, Mesh<3> const& body)
{
  scenario::FieldNodes nodes(body, {});
  nodes.places = places;
  nodes.regions.assign(places.size(), 0);
  nodes.ids.assign(places.size(), 0);
  return nodes;
}

void requireBoundaries(std::vector<scenario::BoundaryCondition> const& conditions,
                       Model const& model)
{
  std::vector<std::string> names;
  for (auto const& surface : model.surfaces) {
    names.push_back(surface.name);
  }
  for (auto const& condition : conditions) {
    ASPERITY_REQUIRE(std::count(names.begin(), names.end(), condition.boundary) > 0,
                     condition.name << " / Boundary = '" << condition.boundary
                                    << "': the mesh will not have such a boundary or fault, only "
                                    << quotedNames(names) << '.'
                                    << didYouMean(condition.boundary, names));
  }
}

// Empty if friction weakens nowhere, or its laws do not say by how much.
std::optional<dynamics::FaultResolution>
resolutionOf(ParameterList const& deck, scenario::BulkSettings const& bulk,
             scenario::FrictionSettings const& settings, Samples const& samples, bool is_y_up,
             CellSize const& size, fem::OtherSide const& other_side)
{
  const auto body = bodyOfOneRegion();
  std::vector<std::array<double, 3>> places;
  for (auto const& x : samples.places) {
    places.push_back(is_y_up ? Point<3>{x[0], x[2], -x[1]} : x);
  }
  const auto nodes = nodesAt(places, body);
  auto const& friction = deck.sublist("Friction");
  const auto sensitivity = scenario::sensitivities(settings.laws, friction, nodes);
  const auto drop = scenario::strengthDrops(settings.laws, friction, nodes);
  const auto slip_distance = scenario::slipDistances(settings.laws, friction, nodes);
  if ((!sensitivity && !drop) || !slip_distance) {
    return std::nullopt;
  }
  const double factor = settings.normal_stress_factor;
  const auto stress =
    scenario::NodalField(
      Field(friction, "Normal Stress", scenario::friction_path, nodes.region_names), nodes)
      .at(0);
  const auto rock = scenario::elasticRockAt(bulk, deck.sublist("Bulk"), body,
                                            std::vector<int>(places.size(), 0), places);
  const bool weakens_at_high_rates = settings.laws.stateLaw().weakens_at_high_rates;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  dynamics::FaultResolution result{infinity, 0, infinity, infinity, infinity, infinity, 0};
  double weakening_area = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double sigma = factor * stress[i], L = (*slip_distance)[i];
    const double a = drop ? 0 : (*sensitivity)[i].slip_rate, b = drop ? 0 : (*sensitivity)[i].state;
    if (!(sigma > 0) || !(drop ? (*drop)[i] > 0 : b > a || weakens_at_high_rates)) {
      continue;
    }
    const double modulus = dynamics::slipModulus(rock[i], components, other_side);
    const double zone = drop ? dynamics::slipWeakeningZone(modulus, (*drop)[i], L, sigma)
                             : dynamics::cohesiveZone(modulus, b, L, sigma);
    const double nucleation = drop ? dynamics::slipWeakeningLength(modulus, (*drop)[i], L, sigma)
                                   : dynamics::nucleationLength(modulus, a, b, L, sigma);
    const double wavelength =
      drop ? nucleation : dynamics::unstableWavelength(modulus, a, b, L, sigma);
    // As of the facets of a mesh: the leg of a right triangle of the same area.
    const double cell = std::sqrt(std::sqrt(0.75)) * size(samples.places[i]);
    result.smallest_cell = std::min(result.smallest_cell, cell);
    result.largest_cell = std::max(result.largest_cell, cell);
    result.cohesive_zone = std::min(result.cohesive_zone, zone);
    result.nucleation_length = std::min(result.nucleation_length, nucleation);
    result.unstable_wavelength = std::min(result.unstable_wavelength, wavelength);
    result.cells_per_zone = std::min(result.cells_per_zone, zone / cell);
    weakening_area += samples.areas[i];
  }
  if (!(weakening_area > 0)) {
    return std::nullopt;
  }
  result.weakening_length = std::sqrt(weakening_area);
  return result;
}

// `where` begins messages, since the deck of the mesh has lists of the same names.
RCP<ParameterList> readDeckOf(BuildSettings const& settings, std::string const& where)
{
  CommandLine command_line;
  command_line.deck = settings.deck;
  command_line.overlays = settings.overlays;
  try {
    return scenario::readCompleteDeck(command_line);
  } catch (InputError const& error) {
    throw InputError(where + error.what());
  }
}

void reportSize(ParameterList const& deck, CellEstimate const& cells, std::ostream& out)
{
  const double refined = std::pow(8, deck.sublist("Mesh").get<int>("Refinements"));
  const double unknowns = components * refined * (cells.vertices + cells.fault_facets / 2);
  const auto solver = scenario::makeSolverSettings(
    scenario::SolverSettings::from(deck.sublist("TNNMG")), 1, 3, static_cast<long long>(unknowns));
  out << "about " << about(unknowns) << " unknowns; ";
  if (solver.correction == dynamics::Correction::direct) {
    out << "the factors of the direct correction take the memory\n";
    return;
  }
  auto const [least, most] = tnnmg::MultigridCorrection::usual_bytes_per_unknown;
  out << "multigrid usually takes " << about(least * unknowns / 1e6) << " to "
      << about(most * unknowns / 1e6) << " MB, and a step of quasi-dynamic earthquakes about "
      << about(step_seconds * unknowns) << " s of one core\n";
}
} // namespace

void reportDeck(Complex const& complex, BuildSettings const& settings, CellSize const& size,
                CellEstimate const& cells, std::ostream& out)
{
  const auto of = "deck '" + settings.deck + "': ";
  const auto deck = readDeckOf(settings, of);
  const auto bulk = scenario::BulkSettings::from(deck->sublist("Bulk"));
  ASPERITY_REQUIRE(bulk.components == components,
                   of << "its model has one or two components of displacement, and a mesh in space "
                         "needs Bulk / Model = Solid.");
  const auto conditions = scenario::readConditions(deck->sublist("Boundary Conditions"));
  requireBoundaries(conditions, settings.model);
  out << of;
  reportSize(*deck, cells, out);

  const auto boundary = scenario::makeBoundaryConditions<3>(conditions, components);
  std::vector<std::string> faults;
  for (auto const& name : boundary.faults) {
    if (std::count(boundary.given_slip.begin(), boundary.given_slip.end(), name) == 0) {
      faults.push_back(name);
    }
  }
  const auto samples = samplesOf(faults, complex, settings.model, size);
  auto const& friction = deck->sublist("Friction");
  if (samples.places.empty()) {
    out << of << "no fault has friction\n";
    return;
  }
  if (!isGiven(friction, "Normal Stress")) {
    out << of
        << "the normal stress follows from its static solution, so that the cohesive zone is "
           "known only when it runs\n";
    return;
  }
  const auto friction_settings = scenario::FrictionSettings::from(friction);
  const auto resolution = resolutionOf(*deck, bulk, friction_settings, samples, settings.is_y_up,
                                       size, boundary.other_side);
  if (!resolution) {
    out << of << "friction weakens nowhere, or its law has no cohesive zone\n";
    return;
  }
  auto const& laws = friction_settings.laws;
  for (auto const& line : scenario::describe(*resolution, laws, "File")) {
    out << of << line << '\n';
  }
  for (auto const& warning : scenario::warnOfResolution(*resolution, laws)) {
    warn(of + warning.text);
  }
}
} // namespace asperity::geometry
