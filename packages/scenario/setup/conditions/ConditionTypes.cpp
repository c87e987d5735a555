#include "scenario/setup/conditions/ConditionTypes.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "parameters/fields/Field.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"
#include "scenario/setup/conditions/TractionCondition.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace asperity::scenario
{
namespace
{
// Smooth from 0 at t = 0 to 1 at t = duration (thesis §5.2).
double ramp(double t, double duration)
{
  return t >= duration ? 1 : (1 - std::cos(M_PI * t / duration)) / 2;
}

std::vector<double> axis(int components, int which)
{
  std::vector<double> direction(components, 0.);
  direction[which] = 1;
  return direction;
}

void refuseDirection(BoundaryCondition const& condition, char const* why)
{
  ASPERITY_REQUIRE(!isGiven(condition.list, "Direction"), joinPath(condition.name, "Direction")
                                                            << " has no effect: " << why
                                                            << ". Remove it.");
}

std::vector<double> directionOf(BoundaryCondition const& condition, int components)
{
  if (components == 1) {
    refuseDirection(condition, "an antiplane body moves along z alone");
    return {1.};
  }
  if (!isGiven(condition.list, "Direction")) {
    return axis(components, 0);
  }
  auto const given = condition.list.get<Teuchos::Array<double>>("Direction").toVector();
  double square = 0;
  for (double component : given) {
    square += component * component;
  }
  ASPERITY_REQUIRE(static_cast<int>(given.size()) == components && square > 0,
                   joinPath(condition.name, "Direction")
                     << " needs "
                     << (components == 3
                           ? "three numbers, not all zero: where the velocity points, "
                             "in x, y and z."
                           : "two numbers, not both zero: where the velocity points, "
                             "in x and y."));
  return given;
}

double rampDuration(ParameterList const& list)
{
  return isGiven(list, "Ramp Duration") ? list.get<double>("Ramp Duration") : 0;
}

std::shared_ptr<const Field> fieldOf(BoundaryCondition const& condition, std::string const& entry)
{
  return std::make_shared<Field>(condition.list, entry, condition.name, std::vector<std::string>{});
}

std::shared_ptr<const Field> velocityField(BoundaryCondition const& condition)
{
  return isGiven(condition.list, "Velocity") ? fieldOf(condition, "Velocity")
                                             : std::make_shared<Field>(Field::constant(0));
}

// One fault, or several inside the body.
template <int Dim>
void fault(BoundaryCondition const& condition, ConditionContext const& setting,
           BoundaryConditions<Dim>& result)
{
  auto const& other_side = condition.type->other_side;
  ASPERITY_REQUIRE(result.faults.empty() || (result.other_side.is_inside && other_side.is_inside),
                   condition.name << ": there is already a fault, the boundary '"
                                  << result.faults.front()
                                  << "'. There can be several only if all are of the Type "
                                  << quotedAlternatives(faultKindsInside()) << ".");
  result.faults.push_back(condition.boundary);
  if (isGiven(condition.list, "Slip Rate")) {
    result.given_slip.push_back(condition.boundary);
  }
  result.other_side = other_side;
  auto const plate = plateRateOf(condition, setting.components);
  if (plate) {
    result.plate_rates.push_back(plate);
  }
}

// Under back slip the slip rate of a continuation, too, is slip factor v_t + Vp, where Vp is the
// plate rate of the first fault that has one.
template <int Dim>
fem::VelocityFunction<Dim> withoutPlates(std::shared_ptr<const Field> const& rate,
                                         BoundaryConditions<Dim> const& conditions)
{
  auto const plate = conditions.plate_rates.empty() ? nullptr : conditions.plate_rates.front().rate;
  const double factor = conditions.other_side.slip_factor;
  auto const of_bodies = [rate, plate, factor](Point<Dim> const& x, double t) {
    return ((*rate)(inSpace<Dim>(x), t, 0) - (plate ? (*plate)(inSpace<Dim>(x), 0, 0) : 0)) /
           factor;
  };
  return {of_bodies, rate->dependsOnTime()};
}

// In three dimensions the continuation of a fault slips in the direction of the plates.
template <int Dim>
void requireDirectionOfPlates(BoundaryCondition const& condition,
                              std::vector<double> const& direction,
                              BoundaryConditions<Dim> const& conditions)
{
  if (conditions.plate_rates.empty()) {
    return;
  }
  auto const& plate = conditions.plate_rates.front();
  auto const& of_plates = plate.direction;
  double product = 0;
  double squares = 1;
  for (auto const* vector : {&direction, &of_plates}) {
    squares *=
      (*vector)[0] * (*vector)[0] + (*vector)[1] * (*vector)[1] + (*vector)[2] * (*vector)[2];
  }
  for (int d = 0; d < 3; ++d) {
    product += direction[d] * of_plates[d];
  }
  ASPERITY_REQUIRE(product >= std::sqrt(squares) * (1 - 1e-12),
                   joinPath(condition.name, "Direction")
                     << " is not that of " << plate.name
                     << ", which has a Plate Rate: its continuation slips in the same direction. "
                        "Give both the same.");
}

template <int Dim>
void prescribedVelocity(BoundaryCondition const& condition, ConditionContext const& setting,
                        BoundaryConditions<Dim>& result)
{
  auto const field = velocityField(condition);
  const double duration = rampDuration(condition.list);
  const fem::VelocityFunction<Dim> velocity(
    [field, duration](Point<Dim> const& x, double t) {
      return ramp(t, duration) * (*field)(inSpace<Dim>(x), t, 0);
    },
    duration > 0 || field->dependsOnTime());
  auto const direction = directionOf(condition, setting.components);
  result.velocities.push_back(
    {condition.name, condition.boundary, fem::PrescribedVelocity<Dim>{direction, velocity}});
  result.ramp_end = std::max(result.ramp_end, duration);
}

template <int Dim>
void absorbing(BoundaryCondition const& condition, ConditionContext const&,
               BoundaryConditions<Dim>& result)
{
  result.absorbing.push_back(condition.boundary);
}

template <int Dim>
void slidingWall(BoundaryCondition const& condition, ConditionContext const& setting,
                 BoundaryConditions<Dim>& result)
{
  if (setting.components > 1) { // antiplane motion is along every boundary
    result.velocities.push_back({condition.name, condition.boundary, fem::SlidingWall{}});
  }
}

template <int Dim>
void fixed(BoundaryCondition const& condition, ConditionContext const& setting,
           BoundaryConditions<Dim>& result)
{
  for (int c = 0; c < setting.components; ++c) {
    result.velocities.push_back(
      {condition.name, condition.boundary, fem::AtRestAlong{axis(setting.components, c)}});
  }
}

template <int Dim>
void freeSurface(BoundaryCondition const& condition, ConditionContext const&,
                 BoundaryConditions<Dim>& result)
{
  if (result.surface.empty()) {
    result.surface = condition.boundary;
  }
  result.free_surfaces.push_back(condition.boundary);
}
} // namespace

// v_t = (slip rate - Vp) / slip factor: along the tangent of the frames, in three dimensions along
// the projection of the direction onto the boundary, and none at right angles to it.
template <int Dim>
void prescribeSlipRate(BoundaryCondition const& condition, ConditionContext const& setting,
                       BoundaryConditions<Dim>& result)
{
  ASPERITY_REQUIRE(isGiven(condition.list, "Slip Rate"),
                   joinPath(condition.name, "Slip Rate")
                     << " is missing: the rate at which the boundary slips, 0 if it is locked.");
  auto const rate = fieldOf(condition, "Slip Rate");
  auto const velocity = withoutPlates(rate, result);
  if (setting.components < 3) {
    refuseDirection(condition, "in two dimensions a fault slips along its tangent");
  }
  const auto add = [&](typename fem::VelocityCondition<Dim>::Kind const& kind) {
    result.velocities.push_back({condition.name, condition.boundary, kind});
  };
  if (setting.components == 1) {
    add(fem::PrescribedVelocity<Dim>{{1.}, velocity});
  } else if (setting.components == 2) {
    add(fem::SlipAlongTangent<Dim>{velocity, setting.along_fault});
  } else {
    auto const direction = directionOf(condition, setting.components);
    requireDirectionOfPlates(condition, direction, result);
    add(fem::SlipTowards<Dim>{direction, velocity, setting.along_fault});
    add(fem::NoSlipSideways{direction, setting.along_fault});
  }
}

template void prescribeSlipRate(BoundaryCondition const&, ConditionContext const&,
                                BoundaryConditions<2>&);
template void prescribeSlipRate(BoundaryCondition const&, ConditionContext const&,
                                BoundaryConditions<3>&);

namespace
{
// A type for each kind of fault, then the types for other boundaries.
std::vector<ConditionType> makeTypes()
{
  std::vector<ConditionType> types;
  for (auto const& name : faultKinds()) {
    auto const& kind = FaultKindRegistry::instance().at(name);
    types.push_back({name,
                     kind.meaning,
                     {"Direction", "Plate Rate", "Slip Rate"},
                     ConditionPlace::fault,
                     DecidesOn::traction,
                     {fault<2>, fault<3>},
                     kind.other_side});
  }
  const std::vector<ConditionType> others = {
    {"Prescribed Slip Rate",
     "the boundary continues the fault and slips at that rate; where no boundary is a fault of "
     "another Type, it is a fault itself, inside the mesh.",
     {"Direction", "Slip Rate"},
     ConditionPlace::continuation,
     DecidesOn::traction,
     {prescribeSlipRate<2>, prescribeSlipRate<3>}},
    {"Prescribed Velocity",
     "the velocity in one direction is prescribed, and free at right angles to it.",
     {"Direction", "Velocity", "Ramp Duration"},
     ConditionPlace::elsewhere,
     DecidesOn::direction,
     {prescribedVelocity<2>, prescribedVelocity<3>}},
    {"Absorbing",
     "dashpots take up the waves.",
     {},
     ConditionPlace::elsewhere,
     DecidesOn::traction,
     {absorbing<2>, absorbing<3>}},
    {"Sliding Wall",
     "the body slides along the boundary (v . n = 0).",
     {},
     ConditionPlace::elsewhere,
     DecidesOn::direction,
     {slidingWall<2>, slidingWall<3>}},
    {"Fixed",
     "the body is at rest (v = 0), although slip would move it a little: displacements near the "
     "boundary are too small, so keep it far away.",
     {},
     ConditionPlace::elsewhere,
     DecidesOn::rest,
     {fixed<2>, fixed<3>}},
    {"Free Surface",
     "there is no traction, which is the default; name it so that its motion can be written and up "
     "follows from it.",
     {},
     ConditionPlace::elsewhere,
     DecidesOn::freedom,
     {freeSurface<2>, freeSurface<3>}}};
  types.insert(types.end(), others.begin(), others.end());
  types.push_back(tractionType());
  return types;
}
} // namespace

std::vector<ConditionType> const& conditionTypes()
{
  static const auto types = makeTypes();
  return types;
}

ConditionType const& conditionType(std::string const& name)
{
  auto const& types = conditionTypes();
  auto const found = std::find_if(types.begin(), types.end(),
                                  [&name](auto const& type) { return type.name == name; });
  ASPERITY_ASSERT(found != types.end());
  return *found;
}
} // namespace asperity::scenario
