#include "scenario/setup/conditions/BoundarySetup.hpp"

#include "base/Text.hpp"
#include "scenario/setup/conditions/BoundaryChecks.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"

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
void layAlongFault(Conditions const& conditions, ConditionContext const& setting,
                   BoundaryConditions<Dim>& result)
{
  auto& velocities = result.velocities;
  for (auto const& condition : conditions) {
    if (condition.liesAlongFault()) {
      fem::VelocityCondition<Dim> across = {condition.name, condition.boundary,
                                            fem::ContactAcrossFault{setting.along_fault}};
      if (result.other_side.is_mirrored) {
        across.kind = fem::FreeAcrossFault{setting.along_fault};
      }
      const bool is_fault = condition.type->place == ConditionPlace::fault;
      velocities.insert(is_fault ? velocities.begin() : velocities.end(), across);
    }
  }
}

template <int Dim>
void make(BoundaryCondition const& condition, ConditionContext const& setting,
          BoundaryConditions<Dim>& result)
{
  std::get<ConditionMaker<Dim>>(condition.type->makers)(condition, setting, result);
}
} // namespace

RCP<const ParameterList> boundaryParameters()
{
  auto const one =
    Declare()
      .text("Boundary", required, "Names the boundary of the mesh on which the condition holds.")
      .choice("Type", required, typeNames(), meaningOfType())
      .realArray(
        "Direction", optional, "-", Range::any(),
        "Prescribed Velocity: components along the axes that say where the velocity points, of any "
        "length; it points along +x if they are left out, and an antiplane body moves along z "
        "alone. Prescribed Slip Rate, and faults with a Plate Rate, in three dimensions: the slip "
        "points along the projection of this vector onto the boundary.")
      .field(
        "Velocity", optional, "m/s", Range::any(),
        "Prescribed Velocity: says how fast the boundary moves in that direction; it is at rest if "
        "this is left out.")
      .real("Ramp Duration", optional, "s", Range::atLeast(0),
            "Prescribed Velocity: sets the time over which the velocity grows smoothly from zero; "
            "without this entry there is no ramp.")
      .field("Plate Rate", optional, "m/s", Range::any(),
             "Faults: says how fast the plates slide past each other along the fault (back slip). "
             "Friction and all outputs of slip include this rate in addition to the motion of the "
             "bodies, whose far boundaries are then at rest. It points along the tangent of the "
             "fault's frame, in three dimensions along Direction, and is constant in time.")
      .field("Slip Rate", optional, "m/s", Range::any(),
             "Prescribed Slip Rate: says how fast the boundary slips; in two dimensions along the "
             "tangent of the fault's frame, which points along +x on a fault below the body.")
      .list();
  return Declare()
    .sublist("<condition>", one, "Describes one boundary condition; choose any name.")
    .list();
}

template <int Dim>
BoundaryConditions<Dim> makeBoundaryConditions(ParameterList const& list, int components)
{
  auto const conditions = readConditions(list);
  refuseUnreadEntries(conditions);
  refuseContradictions(conditions);
  const ConditionContext setting = {components, faultAndContinuations(conditions)};
  BoundaryConditions<Dim> result;
  for (auto const& condition : conditions) {
    if (condition.type->place == ConditionPlace::fault) {
      make(condition, setting, result);
    }
  }
  ASPERITY_REQUIRE(!result.faults.empty(),
                   "Asperity / Boundary Conditions has no condition of Type "
                     << quotedAlternatives(faultKinds())
                     << ". Name the boundary that is the fault.");
  if (components > 1) {
    layAlongFault(conditions, setting, result);
  }
  for (auto const& condition : conditions) {
    if (condition.type->place != ConditionPlace::fault) {
      make(condition, setting, result);
    }
  }
  return result;
}

template BoundaryConditions<2> makeBoundaryConditions(ParameterList const&, int);
template BoundaryConditions<3> makeBoundaryConditions(ParameterList const&, int);
} // namespace asperity::scenario
