// A condition on the velocity of your own: the boundary turns like a rigid body.
// scenario/setup/conditions/BoundaryKind.hpp says what a condition has to have.
#include "base/Errors.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/ConditionEntries.hpp"

#include <optional>
#include <vector>

using namespace asperity;
using namespace asperity::scenario;

namespace
{
// v = omega e_z x (x - c): about an axis through c along z.
struct TurningBoundary
{
  static constexpr char const* meaning = "the boundary turns about an axis along z.";
  static constexpr auto decides_on = DecidesOn::rest; // all components are prescribed

  std::optional<double> rate;                // omega [1/s], else 0
  std::optional<std::vector<double>> centre; // c [m], else the origin

  // They join those of other types, so that none has a default.
  static Entries<TurningBoundary> entries(ParameterList& list)
  {
    Entries<TurningBoundary> entries({}, list);
    entries
      .real("Turning Rate", &TurningBoundary::rate, optional, "1/s", Range::any(),
            "Turning Boundary: the angular velocity, counterclockwise seen against +z.")
      .realArray("Turning Centre", &TurningBoundary::centre, optional, "m", Range::any(),
                 "Turning Boundary: x and y of the axis.");
    return entries;
  }
  static void declare(Declare& declare) { entries(*declare.list()); }

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const& context,
                  BoundaryConditions<Dim>& result)
  {
    ParameterList declared;
    auto const given = entries(declared).read(condition.list, condition.name);
    auto const centre = given.centre.value_or(std::vector<double>{0, 0});
    ASPERITY_REQUIRE(centre.size() == 2, joinPath(condition.name, "Turning Centre")
                                           << " has " << centre.size()
                                           << " numbers, but needs x and y.");
    ASPERITY_REQUIRE(context.components > 1,
                     condition.name << ": an antiplane body moves along z alone, and cannot turn. "
                                       "Choose another Type.");
    for (int c = 0; c < context.components; ++c) {
      auto const velocity = [rate = given.rate.value_or(0), centre, c](Point<Dim> const& x,
                                                                       double) {
        return c == 0 ? -rate * (x[1] - centre[1]) : c == 1 ? rate * (x[0] - centre[0]) : 0.;
      };
      result.velocities.push_back(
        {condition.name, condition.boundary,
         fem::PrescribedVelocity<Dim>{axis(context.components, c), {velocity, false}}});
    }
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Turning Boundary", BoundaryKindOf<TurningBoundary>)
