#include "scenario/setup/conditions/ConditionEntries.hpp"

#include "base/Errors.hpp"

namespace asperity::scenario
{
std::vector<double> axis(int components, int which)
{
  std::vector<double> direction(components, 0.);
  direction[which] = 1;
  return direction;
}

void refuseDirection(BoundaryCondition const& condition, char const* why)
{
  ASPERITY_REQUIRE(!condition.direction, joinPath(condition.name, condition_entries::direction)
                                           << " has no effect: " << why << ". Remove it.");
}

std::vector<double> directionOf(BoundaryCondition const& condition, int components)
{
  if (components == 1) {
    refuseDirection(condition, "an antiplane body moves along z alone");
    return {1.};
  }
  if (!condition.direction) {
    return axis(components, 0);
  }
  auto const& given = *condition.direction;
  double square = 0;
  for (double component : given) {
    square += component * component;
  }
  ASPERITY_REQUIRE(static_cast<int>(given.size()) == components && square > 0,
                   joinPath(condition.name, condition_entries::direction)
                     << " needs "
                     << (components == 3
                           ? "three numbers, not all zero: where the velocity points, "
                             "in x, y and z."
                           : "two numbers, not both zero: where the velocity points, "
                             "in x and y."));
  return given;
}

std::shared_ptr<const Field> fieldIfGiven(BoundaryCondition const& condition,
                                          std::string const& entry)
{
  if (!isGiven(condition.list, entry)) {
    return nullptr;
  }
  auto const field =
    std::make_shared<Field>(condition.list, entry, condition.name, std::vector<std::string>{});
  ASPERITY_REQUIRE(!field->isDataset(),
                   joinPath(condition.name, entry)
                     << " is a dataset. Give a number or an expression in x, y, z and t.");
  return field;
}

} // namespace asperity::scenario
