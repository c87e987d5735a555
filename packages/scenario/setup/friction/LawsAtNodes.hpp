#pragma once

#include "friction/Types.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace asperity::scenario
{
// The two chosen laws with the values of their parameters at fault nodes. The fields of the deck
// are evaluated once, by the constructor.
class LawsAtNodes
{
public:
  // list: the deck's list `Friction`. InputError if a value is outside its range.
  LawsAtNodes(LawChoice const& laws, ParameterList const& list, FieldNodes const& nodes);

  LawChoice const& laws() const { return laws_; }

  // The values (num_parameters, num_nodes), on the device.
  friction::ParameterView frictionParameters() const;
  friction::ParameterView stateParameters() const;

  // Properties of the laws (num_nodes), see friction/LawProperties.hpp; empty if a law does not
  // declare the property.
  std::optional<std::vector<friction::Sensitivity>> sensitivities() const;
  std::optional<std::vector<double>> slipDistances() const;
  std::optional<std::vector<double>> referenceFriction() const;
  std::optional<std::vector<double>> strengthDrops() const;
  std::optional<std::vector<double>> thetaScales() const;

  // c / b of Linker and Dieterich's term (num_nodes) [-]; empty if c is zero at all of them.
  // InputError where c > 0 and the friction law has no b, or b = 0. nodes: as above.
  std::vector<double> stressSensitivities(FieldNodes const& nodes) const;

private:
  // Of one law: its parameters, those of one node side by side.
  struct Values
  {
    std::size_t num_parameters = 0, num_nodes = 0;
    std::vector<double> by_node; // (num_nodes * num_parameters)
  };
  static Values valuesOf(std::vector<friction::Parameter> const& table, ParameterList const& list,
                         FieldNodes const& nodes);
  static friction::ParameterView onDevice(Values const& values);
  template <class Value>
  static std::optional<std::vector<Value>>
  propertyOf(std::function<Value(double const*)> const& function, Values const& values);

  LawChoice laws_;
  Values of_friction_, of_state_;
};
} // namespace asperity::scenario
