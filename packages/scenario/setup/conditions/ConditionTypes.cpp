#include "scenario/setup/conditions/ConditionTypes.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "parameters/fields/Field.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/ConditionEntries.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace asperity::scenario
{
namespace
{
constexpr char const* prescribed_slip_rate = "Prescribed Slip Rate";

// One fault, or several inside the body.
template <int Dim>
void fault(BoundaryCondition const& condition, ConditionContext const& context,
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
  auto const plate = plateRateOf(condition, context.components);
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
} // namespace

// v_t = (slip rate - Vp) / slip factor: along the tangent of the frames, in three dimensions along
// the projection of the direction onto the boundary, and none at right angles to it.
template <int Dim>
void prescribeSlipRate(BoundaryCondition const& condition, ConditionContext const& context,
                       BoundaryConditions<Dim>& result)
{
  ASPERITY_REQUIRE(isGiven(condition.list, "Slip Rate"),
                   joinPath(condition.name, "Slip Rate")
                     << " is missing: the rate at which the boundary slips, 0 if it is locked.");
  auto const rate = fieldIfGiven(condition, "Slip Rate");
  auto const velocity = withoutPlates(rate, result);
  if (context.components < 3) {
    refuseDirection(condition, "in two dimensions a fault slips along its tangent");
  }
  const auto add = [&](typename fem::VelocityCondition<Dim>::Kind const& kind) {
    result.velocities.push_back({condition.name, condition.boundary, kind});
  };
  if (context.components == 1) {
    add(fem::PrescribedVelocity<Dim>{{1.}, velocity});
  } else if (context.components == 2) {
    add(fem::SlipAlongTangent<Dim>{velocity, context.along_fault});
  } else {
    auto const direction = directionOf(condition, context.components);
    requireDirectionOfPlates(condition, direction, result);
    add(fem::SlipTowards<Dim>{direction, velocity, context.along_fault});
    add(fem::NoSlipSideways{direction, context.along_fault});
  }
}

template void prescribeSlipRate(BoundaryCondition const&, ConditionContext const&,
                                BoundaryConditions<2>&);
template void prescribeSlipRate(BoundaryCondition const&, ConditionContext const&,
                                BoundaryConditions<3>&);

namespace
{
ConditionType faultType(std::string const& name, FaultKind const& kind)
{
  ConditionType type;
  type.name = name;
  type.meaning = kind.meaning;
  type.place = ConditionPlace::fault;
  type.decides_on = DecidesOn::traction;
  type.makers = {fault<2>, fault<3>};
  type.other_side = kind.other_side;
  type.reads = {"Direction", "Plate Rate", "Slip Rate"};
  return type;
}

ConditionType typeOfContinuations()
{
  ConditionType type;
  type.name = prescribed_slip_rate;
  type.meaning =
    "the boundary continues the fault and slips at that rate; where no boundary is a fault of "
    "another Type, it is a fault itself, inside the mesh.";
  type.place = ConditionPlace::continuation;
  type.decides_on = DecidesOn::traction;
  type.makers = {prescribeSlipRate<2>, prescribeSlipRate<3>};
  type.reads = {"Direction", "Slip Rate"};
  return type;
}

// The registered type under its name. Its entries are known only when all libraries are loaded.
ConditionType typeOnBoundary(std::string const& name)
{
  auto type = BoundaryKindRegistry::instance().at(name);
  type.name = name;
  if (type.declare) {
    Declare own;
    type.declare(own);
    for (auto const& entry : *own.list()) {
      type.reads.push_back(entry.first);
    }
  }
  if (type.reads_direction) {
    type.reads.emplace_back("Direction");
  }
  return type;
}

// A type for each kind of fault, then the types for other boundaries.
std::vector<ConditionType> makeTypes()
{
  std::vector<ConditionType> types;
  for (auto const& name : faultKinds()) {
    types.push_back(faultType(name, FaultKindRegistry::instance().at(name)));
  }
  types.push_back(typeOfContinuations());
  for (auto const& name : BoundaryKindRegistry::instance().names()) {
    ASPERITY_REQUIRE(
      std::none_of(types.begin(), types.end(), [&](auto const& type) { return type.name == name; }),
      "The boundary condition '" << name
                                 << "' of a plugin has the name of another Type. "
                                    "Register it under a name of its own.");
    types.push_back(typeOnBoundary(name));
  }
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

bool ConditionType::readsEntry(std::string const& entry) const
{
  return std::find(reads.begin(), reads.end(), entry) != reads.end();
}

ConditionType const& continuationType() { return conditionType(prescribed_slip_rate); }
} // namespace asperity::scenario
