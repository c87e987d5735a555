#include "scenario/setup/conditions/BoundaryKind.hpp"

#include "unit/base/Refusal.hpp"

#include <gtest/gtest.h>

// Two types of boundary condition with an entry of one name, as two plugins may bring them.
namespace asperity::scenario
{
namespace
{
struct Springs
{
  static constexpr char const* meaning = "springs hold the boundary.";
  static constexpr auto decides_on = DecidesOn::traction;
  static void declare(Declare& declare)
  {
    declare.real("Thickness", optional, "m", Range::positive(), "The springs are this long.");
  }
  template <int Dim>
  static void add(BoundaryCondition const&, ConditionContext const&, BoundaryConditions<Dim>&)
  {
  }
};

struct Ice : Springs
{
  static constexpr char const* meaning = "ice lies on the boundary.";
};
} // namespace
} // namespace asperity::scenario

ASPERITY_REGISTER(asperity::scenario::BoundaryKindRegistry, "First Springs",
                  asperity::scenario::BoundaryKindOf<asperity::scenario::Springs>)
ASPERITY_REGISTER(asperity::scenario::BoundaryKindRegistry, "Ice Cover",
                  asperity::scenario::BoundaryKindOf<asperity::scenario::Ice>)

namespace asperity::scenario
{
TEST(SharedEntries, OfTwoTypesAreRefusedWithBothNames)
{
  test::expectRefusal([] { boundaryParameters(); },
                      {"<condition> / Thickness", "'First Springs'", "'Ice Cover'"});
}
} // namespace asperity::scenario
