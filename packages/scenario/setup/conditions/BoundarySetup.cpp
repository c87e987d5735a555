#include "scenario/setup/conditions/BoundarySetup.hpp"

#include "base/Text.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/conditions/BoundaryChecks.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
using Conditions = std::vector<BoundaryCondition>;

std::vector<std::string> typeNames()
{
  std::vector<std::string> names;
  for (auto const& type : conditionTypes()) {
    names.push_back(type.name);
  }
  return names;
}

std::string meaningOfType()
{
  std::string text = "Says what holds on the boundary.";
  for (auto const& type : conditionTypes()) {
    text += " " + type.name + ": " + type.meaning;
  }
  return text;
}

fem::Boundaries faultAndContinuations(Conditions const& conditions)
{
  fem::Boundaries boundaries;
  for (auto const& condition : conditions) {
    if (condition.liesAlongFault()) {
      boundaries.push_back(condition.boundary);
    }
  }
  return boundaries;
}

// The fault comes first, then its continuations: the frames of their nodes follow these conditions,
// and have the same normal where fault and continuation meet.
template <int Dim>
void layAlongFault(Conditions const& conditions, ConditionContext const& context,
                   BoundaryConditions<Dim>& result)
{
  auto& velocities = result.velocities;
  for (auto const& condition : conditions) {
    if (condition.liesAlongFault()) {
      fem::VelocityCondition<Dim> across = {condition.name, condition.boundary,
                                            fem::ContactAcrossFault{context.along_fault}};
      if (result.other_side.is_mirrored) {
        across.kind = fem::FreeAcrossFault{context.along_fault};
      }
      const bool is_fault = condition.type->isFault();
      velocities.insert(is_fault ? velocities.begin() : velocities.end(), across);
    }
  }
}

// Without a fault of another Type, boundaries of the Type Prescribed Slip Rate are the faults.
template <int Dim>
void takeContinuationsAsFaults(Conditions const& conditions, BoundaryConditions<Dim>& result)
{
  result.other_side = fem::OtherSide::body;
  for (auto const& condition : conditions) {
    if (condition.liesAlongFault()) {
      result.faults.push_back(condition.boundary);
      result.given_slip.push_back(condition.boundary);
    }
  }
}

template <int Dim>
void make(BoundaryCondition const& condition, ConditionContext const& context,
          BoundaryConditions<Dim>& result)
{
  std::get<ConditionMaker<Dim>>(condition.type->makers)(condition, context, result);
}
} // namespace

namespace
{
struct CommonEntries
{
  std::string boundary, type;
  std::optional<std::vector<double>> direction;
};

// Those that several types share.
Entries<CommonEntries> commonEntries()
{
  using S = CommonEntries;
  Entries<S> one_condition;
  one_condition
    .text("Boundary", &S::boundary, required,
          "Names the boundary of the mesh on which the condition holds.")
    .choiceOfWords("Type", &S::type, required, typeNames(), meaningOfType())
    .realArray(
      "Direction", &S::direction, optional, "-", Range::any(),
      "Prescribed Velocity: components along the axes that say where the velocity points, of any "
      "length; it points along +x if they are left out, and an antiplane body moves along z "
      "alone. Prescribed Slip Rate, and faults with a Slip Rate or a Plate Rate, in three "
      "dimensions: the slip points along the projection of this vector onto the boundary.")
    .others()
    .field("Plate Rate", optional, "m/s", Range::any(),
           "Faults: says how fast the plates slide past each other along the fault (back slip). "
           "Friction and all outputs of slip include this rate in addition to the motion of the "
           "bodies, whose far boundaries are then at rest. It points along the tangent of the "
           "fault's frame, in three dimensions along Direction, and is constant in time.")
    .withoutDatasets()
    .field("Slip Rate", optional, "m/s", Range::any(),
           "Prescribed Slip Rate, and faults whose slip is known: says how fast the boundary "
           "slips; in two dimensions along the tangent of the fault's frame, which points along "
           "+x on a fault below the body. A fault with a slip rate has no friction.")
    .withoutDatasets();
  return one_condition;
}
} // namespace

BoundaryCondition::BoundaryCondition(std::string const& path, ParameterList const& completed)
    : name(path)
    , list(completed)
{
  auto const common = commonEntries().read(list, name);
  type = &conditionType(common.type);
  boundary = common.boundary;
  direction = common.direction;
}

RCP<const ParameterList> boundaryParameters()
{
  auto one_condition = commonEntries();
  auto const& registry = BoundaryKindRegistry::instance();
  for (auto const& name : registry.names()) {
    if (auto const& declare = registry.at(name).declare) {
      declare(one_condition.others());
    }
  }
  auto const one = one_condition.list();
  return Declare()
    .sublist("<condition>", one, "Describes one boundary condition; choose any name.")
    .list();
}

bool haveFriction(ParameterList const& conditions)
{
  auto const kinds = faultKinds();
  return std::any_of(conditions.begin(), conditions.end(), [&](auto const& entry) {
    if (!conditions.isSublist(entry.first)) {
      return false;
    }
    auto const& condition = conditions.sublist(entry.first);
    return condition.template isType<std::string>("Type") && !isGiven(condition, "Slip Rate") &&
           std::find(kinds.begin(), kinds.end(), condition.template get<std::string>("Type")) !=
             kinds.end();
  });
}

template <int Dim>
BoundaryConditions<Dim> makeBoundaryConditions(std::vector<BoundaryCondition> const& conditions,
                                               int components)
{
  refuseUnreadEntries(conditions);
  refuseContradictions(conditions);
  const ConditionContext context = {components, faultAndContinuations(conditions)};
  BoundaryConditions<Dim> result;
  for (auto const& condition : conditions) {
    if (condition.type->isFault()) {
      make(condition, context, result);
    }
  }
  if (result.faults.empty()) {
    takeContinuationsAsFaults(conditions, result);
  }
  if (components > 1) {
    layAlongFault(conditions, context, result);
  }
  for (auto const& condition : conditions) {
    if (!condition.type->isFault()) {
      make(condition, context, result);
    } else if (isGiven(condition.list, "Slip Rate")) {
      prescribeSlipRate(condition, context, result);
    }
  }
  if (result.surface.empty() && !result.tractions.empty()) {
    result.surface = result.tractions.front().boundary;
  }
  return result;
}

template BoundaryConditions<2> makeBoundaryConditions(std::vector<BoundaryCondition> const&, int);
template BoundaryConditions<3> makeBoundaryConditions(std::vector<BoundaryCondition> const&, int);
} // namespace asperity::scenario
