#include "scenario/setup/friction/FrictionSetup.hpp"

#include "base/parallel/Agreement.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

namespace asperity::scenario
{
RCP<const ParameterList> frictionParameters()
{
  Declare declare;
  declareLaws(declare);
  declare
    .field("Cohesion", 0., "Pa", Range::atLeast(0),
           "The fault bears this shear stress even without normal stress.")
    .field("Normal Stress", optional, "Pa", Range::any(),
           "The fault is under this normal stress, positive in compression. If it is left out, it "
           "follows from the static solution under gravity. Values that become negative after the "
           "start count as zero.")
    .real("Normal Stress Factor", 1., "-", Range::atLeast(0),
          "This factor multiplies the normal stress.")
    .choice("Normal Stress Change", "Fixed", {"Fixed", "Lagged", "Coupled"},
            "Selects whether the change of the compression across the fault since the start of the "
            "run is added to the normal stress. Fixed: it is not. Lagged: the change up to the "
            "beginning of each step is added, with an error of first order in the step size. "
            "Coupled: the change up to its end, solved together with the state of the fault.")
    .real("Normal Stress Floor", 0., "Pa", Range::atLeast(0),
          "The normal stress takes this value where it would fall below.")
    .field("Shear Traction", 0., "Pa", Range::any(),
           "This shear traction acts on the fault in addition to that of the deformation. It "
           "points along the tangent of the fault's frame, which is +x on a fault below the body, "
           "and in three dimensions along the slip direction.")
    .realArray("Slip Direction", std::vector<double>{1., 0., 0.}, "-", Range::any(),
               "In three dimensions the shear traction points along this vector, projected onto "
               "the fault. The length of the vector has no effect.");
  auto const& processes = dynamics::FaultProcessRegistry::instance();
  for (auto const& name : processes.names()) {
    declare.sublist(name, processes.at(name).validParameters(), processes.at(name).meaning());
  }
  return declare.list();
}

dynamics::NormalStressChange normalStressChange(ParameterList const& list)
{
  auto const chosen = list.get<std::string>("Normal Stress Change");
  return chosen == "Fixed"    ? dynamics::NormalStressChange::fixed
         : chosen == "Lagged" ? dynamics::NormalStressChange::lagged
                              : dynamics::NormalStressChange::coupled;
}

double normalStressFloor(ParameterList const& list)
{
  return list.get<double>("Normal Stress Floor");
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

std::vector<std::shared_ptr<const dynamics::FaultProcess>>
enabledProcesses(ParameterList const& list, FieldNodes const& nodes,
                 fem::FaultSurface const& surface,
                 std::shared_ptr<const fem::FaultMesh> const& mesh)
{
  std::vector<std::shared_ptr<const dynamics::FaultProcess>> result;
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
} // namespace

dynamics::Fault makeFault(ParameterList const& list, FieldNodes const& nodes,
                          std::shared_ptr<const fem::FaultSurface> const& surface,
                          std::shared_ptr<const fem::FaultMesh> const& mesh,
                          dynamics::NormalStress const& normal_stress,
                          std::vector<double> const& radiation_damping)
{
  requireSameState(list);
  auto const stress = normal_stress.following(normalStressChange(list), normalStressFloor(list));
  std::vector<double> c_over_b;
  friction::TableView table;
  onEveryRank(*surface->communicator(), [&] {
    table = stateTable(list);
    c_over_b = stressSensitivities(list, nodes);
    requirePressure(list, nodes, c_over_b, stress);
  });
  return {
    surface,
    {list.get<std::string>("Law"), frictionLawValues(list, nodes),
     toDevice(nodalValues(list, "Cohesion", friction_path, nodes), "asperity::scenario::cohesion"),
     list.get<std::string>("State Evolution"), stateLawValues(list, nodes), radiation_damping,
     toDevice(c_over_b, "asperity::scenario::stressSensitivity"),
     enabledProcesses(list, nodes, *surface, mesh), table},
    stress};
}
} // namespace asperity::scenario
