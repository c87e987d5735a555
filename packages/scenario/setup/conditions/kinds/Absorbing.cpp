#include "fem/NodalDamping.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"

namespace asperity::scenario
{
namespace
{
struct Absorbing
{
  static constexpr char const* meaning = "dashpots take up the waves.";
  static constexpr auto decides_on = DecidesOn::traction;

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const&,
                  BoundaryConditions<Dim>& result)
  {
    result.resistances.push_back(fem::absorbingBoundary(condition.boundary));
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Absorbing", BoundaryKindOf<Absorbing>)
} // namespace asperity::scenario
