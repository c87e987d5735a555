#include "scenario/setup/conditions/BoundaryKind.hpp"

namespace asperity::scenario
{
namespace
{
struct SlidingWall
{
  static constexpr char const* meaning = "the body slides along the boundary (v . n = 0).";
  static constexpr auto decides_on = DecidesOn::direction;

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const& context,
                  BoundaryConditions<Dim>& result)
  {
    if (context.components > 1) { // antiplane motion is along every boundary
      result.velocities.push_back({condition.name, condition.boundary, fem::SlidingWall{}});
    }
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Sliding Wall", BoundaryKindOf<SlidingWall>)
} // namespace asperity::scenario
