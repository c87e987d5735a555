#include "parameters/Entries.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/ConditionEntries.hpp"

#include <cmath>
#include <memory>
#include <optional>

namespace asperity::scenario
{
namespace
{
// Smooth from 0 at t = 0 to 1 at t = duration (thesis §5.2).
double ramp(double t, double duration)
{
  return t >= duration ? 1 : (1 - std::cos(M_PI * t / duration)) / 2;
}

struct PrescribedVelocity
{
  static constexpr char const* meaning =
    "the velocity in one direction is prescribed, and free at right angles to it.";
  static constexpr auto decides_on = DecidesOn::direction;
  static constexpr bool reads_direction = true;

  struct Ramp
  {
    std::optional<double> duration; // [s]
  };

  // They join those of the list.
  static Entries<Ramp> entries(ParameterList& list)
  {
    Entries<Ramp> entries({}, list);
    entries.others()
      .field(condition_entries::velocity, optional, "m/s", Range::any(),
             "Prescribed Velocity: says how fast the boundary moves in that direction; it is at "
             "rest if this is left out.")
      .withoutDatasets();
    return entries.real(
      "Ramp Duration", &Ramp::duration, optional, "s", Range::atLeast(0),
      "Prescribed Velocity: sets the time over which the velocity grows smoothly from zero; "
      "without this entry there is no ramp.");
  }
  static void declare(Declare& declare) { entries(*declare.list()); }

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const& context,
                  BoundaryConditions<Dim>& result)
  {
    auto const given = fieldIfGiven(condition, condition_entries::velocity);
    auto const field = given ? given : std::make_shared<const Field>(Field::constant(0));
    ParameterList declared;
    const double duration =
      entries(declared).read(condition.list, condition.name).duration.value_or(0);
    const fem::VelocityFunction<Dim> velocity(
      [field, duration](Point<Dim> const& x, double t) {
        return ramp(t, duration) * (*field)(inSpace<Dim>(x), t, 0);
      },
      duration > 0 || field->dependsOnTime());
    auto const direction = directionOf(condition, context.components);
    result.velocities.push_back(
      {condition.name, condition.boundary, fem::PrescribedVelocity<Dim>{direction, velocity}});
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Prescribed Velocity", BoundaryKindOf<PrescribedVelocity>)
} // namespace asperity::scenario
