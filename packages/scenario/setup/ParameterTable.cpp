#include "scenario/setup/ParameterTable.hpp"

namespace asperity::scenario
{
namespace
{
Range rangeOf(Bounds const& bounds)
{
  return {bounds.lower(), bounds.hasLower(), bounds.upper(), bounds.hasUpper()};
}
} // namespace

Declare declareTable(ParameterTable const& table)
{
  Declare declare;
  for (auto const& parameter : table) {
    auto const declareWith = [&](DefaultOr<FieldValue> const& value) {
      declare
        .field(parameter.name, value, parameter.unit, rangeOf(parameter.bounds), parameter.meaning)
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
