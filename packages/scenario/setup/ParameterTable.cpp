#include "scenario/setup/ParameterTable.hpp"

namespace asperity::scenario
{
namespace
{
Range rangeOf(Parameter const& parameter)
{
  return {parameter.lower, parameter.lower_closed, parameter.upper, parameter.upper_closed};
}
} // namespace

Declare declareTable(ParameterTable const& table)
{
  Declare declare;
  for (auto const& parameter : table) {
    auto const declareWith = [&](DefaultOr<FieldValue> const& value) {
      declare.field(parameter.name, value, parameter.unit, rangeOf(parameter), parameter.meaning)
        .hint(parameter.hint);
    };
    if (parameter.required()) {
      declareWith(required);
    } else {
      declareWith(parameter.default_value);
    }
  }
  return declare;
}
} // namespace asperity::scenario
