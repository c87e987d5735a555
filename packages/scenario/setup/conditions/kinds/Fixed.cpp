#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/ConditionEntries.hpp"

namespace asperity::scenario
{
namespace
{
struct Fixed
{
  static constexpr char const* meaning =
    "the body is at rest (v = 0), although slip would move it a little: displacements near the "
    "boundary are too small, so keep it far away.";
  static constexpr auto decides_on = DecidesOn::rest;

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const& context,
                  BoundaryConditions<Dim>& result)
  {
    for (int c = 0; c < context.components; ++c) {
      result.velocities.push_back(
        {condition.name, condition.boundary, fem::AtRestAlong{axis(context.components, c)}});
    }
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Fixed", BoundaryKindOf<Fixed>)
} // namespace asperity::scenario
