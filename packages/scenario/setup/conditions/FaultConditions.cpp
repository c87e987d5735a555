#include "scenario/setup/conditions/FaultConditions.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "parameters/fields/Field.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/conditions/ConditionEntries.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace asperity::scenario
{
namespace
{
// The plate rate under which a boundary slips, or nullptr: a fault has its own; the continuation of
// faults has that of the first one with a plate rate.
template <int Dim>
PlateRate const* platesAt(BoundaryCondition const& condition,
                          BoundaryConditions<Dim> const& conditions)
{
  auto const& all = conditions.plate_rates;
  const auto found =
    condition.type->isFault()
      ? std::find_if(all.begin(), all.end(),
                     [&](PlateRate const& one) { return one.boundary == condition.boundary; })
      : all.begin();
  return found == all.end() ? nullptr : &*found;
}

// The velocity v_t of the bodies at a given slip rate. Under back slip it is without the plates:
// slip rate = slip factor v_t + Vp.
template <int Dim>
fem::VelocityFunction<Dim> withoutPlates(std::shared_ptr<const Field> const& rate,
                                         PlateRate const* plates, double factor)
{
  auto const plate = plates == nullptr ? nullptr : plates->rate;
  auto const of_bodies = [rate, plate, factor](Point<Dim> const& x, double t) {
    return ((*rate)(inSpace<Dim>(x), t, 0) - (plate ? (*plate)(inSpace<Dim>(x), 0, 0) : 0)) /
           factor;
  };
  return {of_bodies, rate->dependsOnTime()};
}

// In three dimensions a boundary slips in the direction of its plates.
void requireDirectionOfPlates(BoundaryCondition const& condition,
                              std::vector<double> const& direction, PlateRate const& plate)
{
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
                   joinPath(condition.name, condition_entries::direction)
                     << " is not that of " << plate.name
                     << ", which has a Plate Rate: its continuation slips in the same direction. "
                        "Give both the same.");
}

// Throws InputError where a fault that may open has no sense.
void requireContact(BoundaryCondition const& condition, ConditionContext const& context,
                    int dimension)
{
  auto const entry = joinPath(condition.name, condition_entries::contact) + " = Unilateral";
  ASPERITY_REQUIRE(!condition.may_open || context.components == dimension,
                   entry << ", but antiplane motion does not open a fault. Remove the entry.");
  ASPERITY_REQUIRE(!condition.may_open || !isGiven(condition.list, condition_entries::slip_rate),
                   entry << ", but the fault has a Slip Rate, and so neither friction nor a normal "
                            "stress that could vanish. Remove one of the two entries.");
}
} // namespace

template <int Dim>
void addFault(BoundaryCondition const& condition, ConditionContext const& context,
              BoundaryConditions<Dim>& result)
{
  auto const& other_side = condition.type->other_side;
  ASPERITY_REQUIRE(result.faults.empty() || (result.other_side.is_inside && other_side.is_inside),
                   condition.name << ": there is already a fault, the boundary '"
                                  << result.faults.front()
                                  << "'. There can be several only if all are of the Type "
                                  << quotedAlternatives(faultKindsInside()) << ".");
  result.faults.push_back(condition.boundary);
  if (condition.givesSlipRate()) {
    result.given_slip.push_back(condition.boundary);
  }
  requireContact(condition, context, Dim);
  const bool may_open = result.other_side.may_open || condition.may_open;
  result.other_side = other_side;
  result.other_side.may_open = may_open;
  auto const plate = plateRateOf(condition, context.components);
  if (plate) {
    result.plate_rates.push_back(plate);
  }
}

template <int Dim>
void prescribeSlipRate(BoundaryCondition const& condition, ConditionContext const& context,
                       BoundaryConditions<Dim>& result)
{
  ASPERITY_REQUIRE(condition.givesSlipRate(),
                   joinPath(condition.name, condition_entries::slip_rate)
                     << " is missing: the rate at which the boundary slips, 0 if it is locked.");
  auto const rate = fieldIfGiven(condition, condition_entries::slip_rate);
  auto const* plates = platesAt(condition, result);
  auto const velocity = withoutPlates<Dim>(rate, plates, result.other_side.slip_factor);
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
    if (plates != nullptr) {
      requireDirectionOfPlates(condition, direction, *plates);
    }
    add(fem::SlipTowards<Dim>{direction, velocity, context.along_fault});
    add(fem::NoSlipSideways{direction, context.along_fault});
  }
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template void addFault(BoundaryCondition const&, ConditionContext const&,                        \
                         BoundaryConditions<Dim>&);                                                \
  template void prescribeSlipRate(BoundaryCondition const&, ConditionContext const&,               \
                                  BoundaryConditions<Dim>&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
