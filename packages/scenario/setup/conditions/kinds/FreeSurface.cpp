#include "scenario/setup/conditions/BoundaryKind.hpp"

namespace asperity::scenario
{
namespace
{
struct FreeSurface
{
  static constexpr char const* meaning =
    "there is no traction, which is the default; name it so that its motion can be written and up "
    "follows from it.";
  static constexpr auto decides_on = DecidesOn::freedom;

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const&,
                  BoundaryConditions<Dim>& result)
  {
    if (result.surface.empty()) {
      result.surface = condition.boundary;
    }
    result.free_surfaces.push_back(condition.boundary);
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Free Surface", BoundaryKindOf<FreeSurface>)
} // namespace asperity::scenario
