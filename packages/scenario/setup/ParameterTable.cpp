#include "scenario/setup/ParameterTable.hpp"

#include <cmath>

namespace asperity::scenario
{
namespace
{
Range rangeOf(Parameter const& parameter)
{
  const bool bounded = std::isfinite(parameter.upper);
  if (!bounded) {
    return parameter.lower_closed ? Range::atLeast(parameter.lower) : Range::above(parameter.lower);
  }
  if (parameter.lower_closed) {
    return parameter.upper_closed ? Range::closed(parameter.lower, parameter.upper)
                                  : Range::closedOpen(parameter.lower, parameter.upper);
  }
  return parameter.upper_closed ? Range::openClosed(parameter.lower, parameter.upper)
                                : Range::open(parameter.lower, parameter.upper);
}
} // namespace

RCP<const ParameterList> declareTable(ParameterTable const& table)
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
  return declare.list();
}
} // namespace asperity::scenario
