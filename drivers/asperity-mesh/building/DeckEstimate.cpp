#include "building/DeckEstimate.hpp"

#include "Warnings.hpp"
#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "building/BuildReport.hpp"
#include "meshing/CellSize.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "dynamics/checks/FaultResolution.hpp"
#include "friction/Registry.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/checks/ResolutionCheck.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/friction/LawsAtNodes.hpp"
#include "scenario/setup/mesh/MeshSettings.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "scenario/setup/rock/RockSetup.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <Teuchos_DefaultSerialComm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
// CPU time of one coupled step for each unknown, a rough estimate: BP5, quasi-dynamic, with 291,054
// unknowns takes 1.9 h for 9,287 steps on one core (docs/cost/cost.md). Other cores and problems
// differ by a factor of two; `asperity-bench steps DECK` measures a deck on its mesh.
constexpr double seconds_per_unknown = 1.9 * 3600 / (9287. * 291054);
constexpr int components = 3;

// Places on the faults with friction, and the number of the fault of each among all of the deck.
struct FaultSamples : Samples
{
  std::vector<int> faults;
};

FaultSamples samplesOf(scenario::BoundaryConditions<3> const& boundary, Complex const& complex,
                       Model const& model, CellSize const& size)
{
  auto const& all = boundary.faults;
  auto const with_friction = scenario::faultsWithFriction(boundary);
  FaultSamples samples;
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    const int s = complex.surfaces[i];
    auto const found = std::find(all.begin(), all.end(), model.name(s));
    if (model.isFault(s) && found != all.end() &&
        std::count(with_friction.begin(), with_friction.end(), *found) > 0) {
      addSamples(samples, complex, complex.triangles[i], size);
      samples.faults.resize(samples.places.size(), static_cast<int>(found - all.begin()));
    }
  }
  return samples;
}

// The regions of the mesh, which is not made yet, for fields of the deck that depend on regions.
Mesh<3> regionsOfMesh()
{
  Mesh<3> mesh;
  mesh.region_names = {"body"};
  mesh.cell_regions = {0};
  return mesh;
}

// The samples as nodes of the faults, in the axes of the deck.
scenario::FieldNodes nodesAt(FaultSamples const& samples, std::vector<std::string> const& faults,
                             bool is_y_up)
{
  scenario::FieldNodes nodes(regionsOfMesh(), {});
  for (auto const& x : samples.places) {
    nodes.places.push_back(is_y_up ? Point<3>{x[0], x[2], -x[1]} : x);
  }
  nodes.regions.assign(nodes.places.size(), 0);
  nodes.ids.assign(nodes.places.size(), 0);
  nodes.fault_names = faults;
  nodes.faults = samples.faults;
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

// Friction and normal stress at nodes of faults; empty if the laws do not say how friction
// weakens.
std::optional<dynamics::FrictionOfNodes> frictionAt(scenario::FieldNodes const& nodes,
                                                    ParameterList const& friction,
                                                    scenario::FrictionSettings const& settings)
{
  const scenario::LawsAtNodes laws(settings.laws, friction, nodes);
  const auto sensitivity = laws.sensitivities();
  const auto drop = laws.strengthDrops();
  const auto slip_distance = laws.slipDistances();
  if ((!sensitivity && !drop) || !slip_distance) {
    return std::nullopt;
  }
  dynamics::FrictionOfNodes result;
  result.L = *slip_distance;
  result.sigma_n =
    scenario::NodalField(friction, "Normal Stress", scenario::friction_path, nodes).at(0);
  for (double& stress : result.sigma_n) {
    stress *= settings.normal_stress_factor;
  }
  if (drop) {
    result.drop = *drop;
    return result;
  }
  const bool weakens_at_high_rates = settings.laws.stateLaw().weakens_at_high_rates;
  for (auto const& [a, b] : *sensitivity) {
    // A law that weakens at high slip rates does so even if a and b alone strengthen. Its steady
    // friction is not evaluated here: a = 0 stands for it, with which lengths are the smallest.
    result.a.push_back(weakens_at_high_rates && a >= b ? 0 : a);
    result.b.push_back(b);
  }
  return result;
}

// The cells that are to be made at places of faults. Facets are about equilateral triangles, whose
// size is their side; CellSizes has the leg of a right triangle of the same area, leg^2 / 2.
dynamics::FaultPlaces placesOf(Samples const& samples, CellSize const& size,
                               fem::OtherSide const& other_side)
{
  dynamics::FaultPlaces places{3, other_side, {}, samples.areas};
  for (auto const& place : samples.places) {
    const double leg = std::sqrt(2 * facetArea(size(place)));
    places.cells.push_back({leg, leg});
  }
  return places;
}

// Empty if friction weakens nowhere, or its laws do not say by how much.
std::optional<dynamics::FaultResolution>
resolutionOf(ParameterList const& deck, scenario::BulkSettings const& bulk,
             scenario::FrictionSettings const& settings, FaultSamples const& samples,
             scenario::FieldNodes const& nodes, CellSize const& size,
             fem::OtherSide const& other_side)
{
  const auto friction = frictionAt(nodes, deck.sublist("Friction"), settings);
  if (!friction) {
    return std::nullopt;
  }
  const auto rock = scenario::elasticRockAt(bulk, deck.sublist("Bulk"), regionsOfMesh(),
                                            nodes.regions, nodes.places);
  return dynamics::faultResolution(placesOf(samples, size, other_side), components, rock, *friction,
                                   Teuchos::SerialComm<int>());
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
  auto const mesh = scenario::MeshSettings::from(deck.sublist("Mesh"));
  const double refined = std::pow(8, mesh.num_refinements);
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
      << about(seconds_per_unknown * unknowns) << " s of one core\n";
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
  const auto samples = samplesOf(boundary, complex, settings.model, size);
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
  const auto resolution =
    resolutionOf(*deck, bulk, friction_settings, samples,
                 nodesAt(samples, boundary.faults, settings.is_y_up), size, boundary.other_side);
  if (!resolution) {
    out << of << "friction weakens nowhere, or its law has no cohesive zone\n";
    return;
  }
  auto const& laws = friction_settings.laws;
  const auto advice = scenario::adviceOnLowerCells(
    scenario::MeshSettings::from(deck->sublist("Mesh")), scenario::faultsWithFriction(boundary));
  for (auto const& line : scenario::describe(*resolution, laws, advice)) {
    out << of << line << '\n';
  }
  for (auto const& warning : scenario::warnOfResolution(*resolution, laws)) {
    warn(of + warning.text);
  }
}
} // namespace asperity::geometry
