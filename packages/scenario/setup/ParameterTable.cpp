#include "scenario/setup/ParameterTable.hpp"

namespace asperity::scenario
{
Declare declareTable(ParameterTable const& table)
{
  Declare declare;
  for (auto const& parameter : table) {
    auto const declareWith = [&](DefaultOr<FieldValue> const& value) {
      declare.field(parameter.name, value, parameter.unit, parameter.range, parameter.meaning)
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
