#include "scenario/setup/friction/FrictionSetup.hpp"

#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "dynamics/processes/RegularisedStress.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

#include <algorithm>
#include <limits>

namespace asperity::scenario
{
namespace
{
char const* const change_choice = "Normal Stress Change";
char const* const regularised = "Prakash-Clifton";
char const* const slip_entry = "Slip Distance";
char const* const time_entry = "Time";

RCP<const ParameterList> regularisationParameters()
{
  return Declare()
    .field(slip_entry, optional, "m", Range::positive(),
           "Friction comes nearer to the effective normal stress by a factor e within this slip. "
           "If it is left out, slip has no such effect.")
    .field(time_entry, optional, "s", Range::positive(),
           "It does so within this time, too, whether the fault slips or not. If it is left out, "
           "time has no such effect. One of the two has to be given.")
    .hint("A rate V_ref beside the slip rate is a time of Slip Distance / V_ref.")
    .list();
}

Entries<FrictionSettings> frictionEntries()
{
  using S = FrictionSettings;
  Entries<S> entries;
  auto& declare = entries.others();
  declareLaws(declare);
  declare
    .field("Cohesion", 0., "Pa", Range::atLeast(0),
           "The fault bears this shear stress even without normal stress.")
    .field("Normal Stress", optional, "Pa", Range::any(),
           "The fault is under this normal stress, positive in compression. If it is left out, it "
           "follows from the static solution under gravity. Values that become negative after the "
           "start count as zero.");
  entries
    .real("Normal Stress Factor", &S::normal_stress_factor, "-", Range::atLeast(0),
          "This factor multiplies the normal stress.")
    .choiceOfLists(
      change_choice, &S::change,
      {{"Fixed", Declare().list()},
       {"Lagged", Declare().list()},
       {"Coupled", Declare().list()},
       {regularised, regularisationParameters()}},
      "Selects whether the change of the compression across the fault since the start of the run "
      "is added to the normal stress. Fixed: it is not. Lagged: the change up to the beginning of "
      "each step is added, with an error of first order in the step size. Coupled: the change up "
      "to its end, solved together with the state of the fault. Prakash-Clifton: as Coupled, and "
      "friction follows the effective normal stress with slip and time in place of at once.")
    .real("Normal Stress Floor", &S::floor, "Pa", Range::atLeast(0),
          "The normal stress takes this value where it would fall below.")
    .others()
    .field("Shear Traction", 0., "Pa", Range::any(),
           "This shear traction acts on the fault in addition to that of the deformation. It "
           "points along the tangent of the fault's frame, which is +x on a fault below the body, "
           "and in three dimensions along the slip direction.");
  entries.realArray(
    "Slip Direction", &S::slip_direction, "-", Range::any(),
    "In three dimensions the shear traction points along this vector, projected onto "
    "the fault. The length of the vector has no effect.");
  auto const& processes = dynamics::FaultProcessRegistry::instance();
  for (auto const& name : processes.names()) {
    declare.sublist(name, processes.at(name).validParameters(), processes.at(name).meaning());
  }
  return entries;
}
} // namespace

RCP<const ParameterList> frictionParameters() { return frictionEntries().list(); }

FrictionSettings FrictionSettings::from(ParameterList const& list)
{
  return frictionEntries().read(list, friction_path);
}

dynamics::NormalStressChange normalStressChange(ParameterList const& list)
{
  auto const chosen = FrictionSettings::from(list).change;
  return chosen == "Fixed"    ? dynamics::NormalStressChange::fixed
         : chosen == "Lagged" ? dynamics::NormalStressChange::lagged
                              : dynamics::NormalStressChange::coupled;
}

double normalStressFloor(ParameterList const& list) { return FrictionSettings::from(list).floor; }

bool followsAtOnce(ParameterList const& list)
{
  return normalStressChange(list) != dynamics::NormalStressChange::fixed &&
         FrictionSettings::from(list).change != regularised;
}

namespace
{
// ln(sigma_n) has to be finite wherever its change shifts the state.
void requirePressure(ParameterList const& list, FieldNodes const& nodes,
                     std::vector<double> const& c_over_b,
                     dynamics::NormalStress const& normal_stress)
{
  if (c_over_b.empty() || normalStressFloor(list) > 0) {
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

dynamics::FaultProcesses enabledProcesses(ParameterList const& list, FieldNodes const& nodes,
                                          fem::FaultSurface const& surface,
                                          std::shared_ptr<const fem::FaultMesh> const& mesh)
{
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
        return functionOf({Field(parameters, entry, path, nodes.region_names), nodes});
      };
      result.push_back(
        processes.at(name).make(parameters, {surface, mesh, nodes.places, values, in_time, path}));
      if (char const* needed = result.back()->stateVariable()) {
        requireState(list, needed, path);
      }
    }
  }
  return result;
}

// Null if friction takes the effective normal stress at once.
std::shared_ptr<const dynamics::FaultProcess> regularisation(ParameterList const& list,
                                                             FieldNodes const& nodes,
                                                             fem::FaultSurface const& surface,
                                                             dynamics::FaultProcesses const& before)
{
  if (FrictionSettings::from(list).change != regularised) {
    return nullptr;
  }
  auto const& own = list.sublist(regularised);
  auto const path = joinPath(friction_path, regularised);
  ASPERITY_REQUIRE(isGiven(own, slip_entry) || isGiven(own, time_entry),
                   path << ": neither " << slip_entry << " nor " << time_entry
                        << " is given, so that friction would never follow the normal stress. Give "
                           "one of them or both; with Normal Stress Change = Fixed it does not.");
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto scale = [&](char const* entry) {
    return isGiven(own, entry) ? nodalValues(own, entry, path, nodes)
                               : std::vector<double>(nodes.ids.size(), never);
  };
  dynamics::RegularisationScales scales;
  onEveryRank(*surface.communicator(), [&] { scales = {scale(slip_entry), scale(time_entry)}; });
  return dynamics::makeRegularisedStress(surface, scales, before);
}
} // namespace

std::vector<Warning> warnOfImplausibleFriction(ParameterList const& list, FieldNodes const& nodes,
                                               Communicator const& communicator)
{
  // Rubber on a rough surface has 2 to 4. Barriers may have any, so that the smallest counts.
  constexpr double largest_coefficient = 5;
  // Projectiles that strike rock.
  constexpr double largest_rate = 1000; // m/s
  const auto question = [&](char const* name, char const* unit, double largest,
                            char const* advice) -> std::vector<Warning> {
    if (!isGiven(list, name)) {
      return {};
    }
    double smallest = std::numeric_limits<double>::infinity();
    for (const double value : nodalValues(list, name, friction_path, nodes)) {
      smallest = std::min(smallest, value);
    }
    smallest = minOverRanks(smallest, communicator);
    if (!(smallest > largest) || smallest == std::numeric_limits<double>::infinity()) {
      return {};
    }
    return {{"friction coefficient", joinPath(friction_path, name) + " is " +
                                       formatShort(smallest) + unit +
                                       " or more everywhere on the fault. " + advice}};
  };
  auto warnings = question("Reference Friction Coefficient", "", largest_coefficient,
                           "It is the tangent of an angle, not an angle.");
  auto const of_rate =
    question("Reference Slip Rate", " m/s", largest_rate, "It is a slip rate in m/s.");
  warnings.insert(warnings.end(), of_rate.begin(), of_rate.end());
  return warnings;
}

dynamics::Fault makeFault(ParameterList const& list, FieldNodes const& nodes,
                          std::shared_ptr<const fem::FaultSurface> const& surface,
                          std::shared_ptr<const fem::FaultMesh> const& mesh,
                          dynamics::NormalStress const& normal_stress, bool body_presses,
                          std::vector<double> const& radiation_damping)
{
  requireSameState(list);
  auto const change = body_presses ? normalStressChange(list) : dynamics::NormalStressChange::fixed;
  auto const stress = normal_stress.following(change, normalStressFloor(list));
  std::vector<double> c_over_b;
  friction::TableView table;
  onEveryRank(*surface->communicator(), [&] {
    table = stateTable(list);
    c_over_b = stressSensitivities(list, nodes);
    requirePressure(list, nodes, c_over_b, stress);
  });
  auto const processes = enabledProcesses(list, nodes, *surface, mesh);
  return {
    surface,
    {list.get<std::string>("Law"), frictionLawValues(list, nodes),
     toDevice(nodalValues(list, "Cohesion", friction_path, nodes), "asperity::scenario::cohesion"),
     list.get<std::string>("State Evolution"), stateLawValues(list, nodes), radiation_damping,
     toDevice(c_over_b, "asperity::scenario::stressSensitivity"), processes, table,
     regularisation(list, nodes, *surface, processes)},
    stress};
}
} // namespace asperity::scenario
