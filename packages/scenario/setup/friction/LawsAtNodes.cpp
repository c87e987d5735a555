#include "scenario/setup/friction/LawsAtNodes.hpp"

#include "base/Errors.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <algorithm>

namespace asperity::scenario
{
LawsAtNodes::LawsAtNodes(LawChoice const& laws, ParameterList const& list, FieldNodes const& nodes)
    : laws_(laws)
    , of_friction_(valuesOf(laws.frictionLaw().parameters, list, nodes))
    , of_state_(valuesOf(laws.stateLaw().parameters, list, nodes))
{
}

LawsAtNodes::Values LawsAtNodes::valuesOf(std::vector<friction::Parameter> const& table,
                                          ParameterList const& list, FieldNodes const& nodes)
{
  Values values{table.size(), nodes.ids.size(), {}};
  values.by_node.resize(values.num_nodes * values.num_parameters);
  for (std::size_t row = 0; row < table.size(); ++row) {
    auto const of_nodes = nodalValues(list, table[row].name, friction_path, nodes);
    for (std::size_t node = 0; node < values.num_nodes; ++node) {
      values.by_node[node * values.num_parameters + row] = of_nodes[node];
    }
  }
  return values;
}

friction::ParameterView LawsAtNodes::onDevice(Values const& values)
{
  Kokkos::View<double**, MemorySpace> result("asperity::scenario::lawParameters",
                                             values.num_parameters, values.num_nodes);
  auto const host = Kokkos::create_mirror_view(result);
  for (std::size_t i = 0; i < values.by_node.size(); ++i) {
    host(i % values.num_parameters, i / values.num_parameters) = values.by_node[i];
  }
  Kokkos::deep_copy(result, host);
  return result;
}

template <class Value>
std::optional<std::vector<Value>>
LawsAtNodes::propertyOf(std::function<Value(double const*)> const& function, Values const& values)
{
  if (!function) {
    return std::nullopt;
  }
  std::vector<Value> result;
  for (std::size_t node = 0; node < values.num_nodes; ++node) {
    result.push_back(function(values.by_node.data() + node * values.num_parameters));
  }
  return result;
}

friction::ParameterView LawsAtNodes::frictionParameters() const { return onDevice(of_friction_); }

friction::ParameterView LawsAtNodes::stateParameters() const { return onDevice(of_state_); }

std::optional<std::vector<friction::Sensitivity>> LawsAtNodes::sensitivities() const
{
  return propertyOf(laws_.frictionLaw().sensitivity, of_friction_);
}

std::optional<std::vector<double>> LawsAtNodes::slipDistances() const
{
  return propertyOf(laws_.stateLaw().slip_distance, of_state_);
}

std::optional<std::vector<double>> LawsAtNodes::referenceFriction() const
{
  return propertyOf(laws_.frictionLaw().reference_friction, of_friction_);
}

std::optional<std::vector<double>> LawsAtNodes::strengthDrops() const
{
  return propertyOf(laws_.frictionLaw().strength_drop, of_friction_);
}

std::optional<std::vector<double>> LawsAtNodes::thetaScales() const
{
  return propertyOf(laws_.stateLaw().theta_scale, of_state_);
}

std::vector<double> LawsAtNodes::stressSensitivities(FieldNodes const& nodes) const
{
  auto const c = propertyOf(laws_.stateLaw().stress_sensitivity, of_state_);
  if (!c || std::all_of(c->begin(), c->end(), [](double value) { return value == 0; })) {
    return {};
  }
  auto const of_friction = sensitivities();
  ASPERITY_REQUIRE(of_friction, joinPath(friction_path, "c")
                                  << " is given, but the friction law '" << laws_.friction
                                  << "' has no b, by which the term of Linker and Dieterich "
                                     "is divided. Remove c, or choose another law.");
  std::vector<double> result;
  for (std::size_t i = 0; i < nodes.ids.size(); ++i) {
    const double b = (*of_friction)[i].state;
    ASPERITY_REQUIRE((*c)[i] == 0 || b > 0,
                     joinPath(friction_path, "c")
                       << " = " << (*c)[i] << " at x = " << nodes.text(i) << ", where b = " << b
                       << ": the term of Linker and Dieterich is divided by b. "
                          "Set c to zero there.");
    result.push_back((*c)[i] == 0 ? 0 : (*c)[i] / b);
  }
  return result;
}
} // namespace asperity::scenario
