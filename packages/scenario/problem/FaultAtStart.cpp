#include "scenario/problem/FaultAtStart.hpp"

#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/FirstRank.hpp"
#include "base/parallel/Reductions.hpp"
#include "dynamics/processes/RegularisedStress.hpp"
#include "fem/FaultMesh.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace asperity::scenario
{
namespace
{
std::vector<double> compression(std::vector<double> values, double factor)
{
  for (double& value : values) {
    value = factor * std::max(value, 0.);
  }
  return values;
}

std::vector<double> givenStress(NodalField const& field, FieldNodes const& nodes)
{
  auto const values = field.at(0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASPERITY_REQUIRE(values[i] >= 0, joinPath(friction_path, friction_entries::normal_stress)
                                       << " = " << values[i] << " at x = " << nodes.text(i)
                                       << ", t = 0, is outside [0, inf). Check the sign: "
                                          "compression is positive.");
  }
  return values;
}

// About the normal stress(num_nodes) of the static solution, where it is negative by more than
// rounding.
std::vector<Warning> tensionAtStart(std::vector<double> const& static_stress,
                                    fem::FaultSurface const& surface)
{
  constexpr double rounding = 1e-9; // of the largest stress
  auto const& communicator = *surface.communicator();
  double largest = 0, least = 0;
  for (const double value : static_stress) {
    largest = std::max(largest, std::abs(value));
    least = std::min(least, value);
  }
  largest = maxOverRanks(largest, communicator);
  const double lowest = minOverRanks(least, communicator);
  std::array<double, 2> measure{};
  int first = -1;
  for (int node = 0; node < surface.numNodes(); ++node) {
    const double weight = surface.slides(node) ? surface[node].weight : 0;
    measure[0] += static_stress[node] < -rounding * largest ? weight : 0;
    measure[1] += weight;
    first = static_stress[node] == lowest && first < 0 ? node : first;
  }
  measure = sumOverRanks(measure, communicator);
  if (!(measure[0] > 0)) {
    return {};
  }
  auto const place =
    ofFirstRank<3>(first < 0 ? std::nullopt : std::optional(surface[first].place), communicator);
  return {{"tension at the start",
           "The static solution pulls at " +
             formatShort(std::round(1000 * measure[0] / measure[1]) / 10) +
             " % of the fault, most with " + formatShort(-lowest) + " Pa of tension at " +
             formatPoint({place->begin(), place->end()}) +
             " m: the normal stress of friction is set to zero there, and the model holds the "
             "fault shut. "
             "Check Gravity Direction, Up and the boundary conditions, or give a Normal Stress."}};
}

struct NormalStressOfDeck
{
  dynamics::NormalStress normal_stress;
  std::vector<Warning> warnings;
};

template <int Dim>
NormalStressOfDeck makeNormalStress(SetupContext<Dim> const& context,
                                    std::vector<double> const& static_stress)
{
  auto const& friction = context.settings.lists.friction;
  auto const& nodes = context.site.nodes;
  const double factor = context.settings.friction.normal_stress_factor;
  auto const constant = [factor](std::vector<double> const& values) {
    return dynamics::NormalStress(
      toDevice(compression(values, factor), "asperity::scenario::normalStress"));
  };
  if (!context.settings.friction.gives_normal_stress) {
    return {constant(static_stress), tensionAtStart(static_stress, *context.site.surface)};
  }
  const NodalField given(friction, friction_entries::normal_stress, friction_path, nodes);
  auto const at_start = givenStress(given, nodes);
  if (!given.dependsOnTime()) {
    return {constant(at_start), {}};
  }
  return {dynamics::NormalStress([given, factor](double t, NodeView const& sigma_n) {
            Kokkos::deep_copy(sigma_n, toDevice(compression(given.at(t), factor),
                                                "asperity::scenario::normalStress"));
          }),
          {}};
}

// ln(sigma_n) has to be finite wherever its change shifts the state.
void requirePressure(FieldNodes const& nodes, std::vector<double> const& c_over_b,
                     dynamics::NormalStress const& normal_stress)
{
  if (c_over_b.empty() || normal_stress.floor() > 0) {
    return;
  }
  auto const refused = joinPath(friction_path, "c") + " > 0 needs a normal stress above zero, ";
  ASPERITY_REQUIRE(!normal_stress.dependsOnTime() &&
                     normal_stress.change() == dynamics::NormalStressChange::fixed,
                   refused << "and this one changes. Give a Normal Stress Floor above zero.");
  const NodeView sigma("asperity::scenario::sigma_n", c_over_b.size());
  normal_stress.at(0, sigma);
  auto const values = toHost(sigma);
  for (std::size_t i = 0; i < c_over_b.size(); ++i) {
    ASPERITY_REQUIRE(c_over_b[i] == 0 || values(i) > 0,
                     refused << "and it is " << values(i) << " Pa at x = " << nodes.text(i)
                             << ". Set c to zero there, or give a Normal Stress Floor.");
  }
}

dynamics::NodalFunction functionOf(NodalField const& field)
{
  return {field.dependsOnTime(), [field](double t) { return field.at(t); }};
}

dynamics::FaultProcesses enabledProcesses(LawChoice const& laws, ParameterList const& list,
                                          FaultSite const& site,
                                          std::shared_ptr<const fem::FaultMesh> const& mesh)
{
  auto const& nodes = site.nodes;
  dynamics::FaultProcesses result;
  auto const& processes = dynamics::FaultProcessRegistry::instance();
  for (auto const& name : processes.names()) {
    auto const& parameters = list.sublist(name);
    if (parameters.get<bool>("Enabled")) {
      auto const path = joinPath(friction_path, name);
      const auto values = [&](std::string const& entry) {
        return nodalValues(parameters, entry, path, nodes);
      };
      const auto in_time = [&](std::string const& entry) {
        return functionOf({parameters, entry, path, nodes});
      };
      result.push_back(processes.at(name).make(
        parameters, {*site.surface, mesh, nodes.places, values, in_time, path}));
      if (char const* needed = result.back()->stateVariable()) {
        requireState(laws, needed, path);
      }
    }
  }
  return result;
}

// Null if friction takes the effective normal stress at once.
template <int Dim>
std::shared_ptr<const dynamics::FaultProcess> regularisation(SetupContext<Dim> const& context,
                                                             dynamics::FaultProcesses const& before)
{
  if (context.settings.friction.change != regularisation_list) {
    return nullptr;
  }
  auto const& own = context.settings.lists.friction.sublist(regularisation_list);
  auto const& nodes = context.site.nodes;
  auto const path = joinPath(friction_path, regularisation_list);
  ASPERITY_REQUIRE(isGiven(own, regularisation_slip) || isGiven(own, regularisation_time),
                   path << ": neither " << regularisation_slip << " nor " << regularisation_time
                        << " is given, so that friction would never follow the normal stress. Give "
                           "one of them or both; with Normal Stress Change = Fixed it does not.");
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto scale = [&](char const* entry) {
    return isGiven(own, entry) ? nodalValues(own, entry, path, nodes)
                               : std::vector<double>(nodes.ids.size(), never);
  };
  dynamics::RegularisationScales scales;
  onEveryRank(context.communicator(), [&] {
    scales = {scale(regularisation_slip), scale(regularisation_time)};
  });
  return dynamics::makeRegularisedStress(*context.site.surface, scales, before);
}
} // namespace

template <int Dim>
FaultAtStart makeFault(SetupContext<Dim> const& context, std::vector<double> const& static_stress)
{
  auto const& settings = context.settings.friction;
  auto const& list = context.settings.lists.friction;
  auto const& site = context.site;
  auto const& nodes = site.nodes;
  auto given = makeNormalStress(context, static_stress);
  requireSameState(settings.laws);
  auto const stress = given.normal_stress.following(
    context.bodyPresses() ? settings.normalStressChange() : dynamics::NormalStressChange::fixed,
    settings.floor);
  std::vector<double> c_over_b;
  friction::TableView table;
  std::optional<LawsAtNodes> at_nodes;
  onEveryRank(context.communicator(), [&] {
    table = stateTable(settings.laws, list);
    at_nodes.emplace(settings.laws, list, nodes);
    c_over_b = at_nodes->stressSensitivities(nodes);
    requirePressure(nodes, c_over_b, stress);
  });
  dynamics::FaultLaws laws;
  laws.friction = settings.laws.friction;
  laws.friction_parameters = at_nodes->frictionParameters();
  laws.cohesion = toDevice(nodalValues(list, friction_entries::cohesion, friction_path, nodes),
                           "asperity::scenario::cohesion");
  laws.state = settings.laws.state;
  laws.state_parameters = at_nodes->stateParameters();
  laws.radiation_damping = site.radiation_damping;
  laws.stress_sensitivity = toDevice(c_over_b, "asperity::scenario::stressSensitivity");
  laws.processes = enabledProcesses(settings.laws, list, site,
                                    fem::makeFaultMesh(context.discretisation.mesh, *site.surface));
  laws.state_table = table;
  laws.regularisation = regularisation(context, laws.processes);
  return {dynamics::Fault(site.surface, std::move(laws), stress), std::move(*at_nodes),
          std::move(given.warnings)};
}

template FaultAtStart makeFault(SetupContext<2> const&, std::vector<double> const&);
template FaultAtStart makeFault(SetupContext<3> const&, std::vector<double> const&);
} // namespace asperity::scenario
