#pragma once

#include "parameters/fields/Field.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"

#include <memory>
#include <string>
#include <vector>

// How conditions read their entries.
namespace asperity::scenario
{
// The unit vector along an axis, in `components` components.
std::vector<double> axis(int components, int which);

// Throws InputError with the reason if the condition has the entry `Direction`.
void refuseDirection(BoundaryCondition const& condition, char const* why);
// The entry `Direction`, any length but zero; along x without it. InputError otherwise, and for any
// direction in antiplane motion, where it is {1}.
std::vector<double> directionOf(BoundaryCondition const& condition, int components);

// A number or an expression in x, y, z and t. Null if the entry is not given. InputError for a
// dataset.
std::shared_ptr<const Field> fieldIfGiven(BoundaryCondition const& condition,
                                          std::string const& entry);
} // namespace asperity::scenario
