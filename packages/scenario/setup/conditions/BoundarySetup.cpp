#include "scenario/setup/conditions/BoundarySetup.hpp"

#include "scenario/setup/conditions/BoundaryChecks.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/conditions/FaultConditions.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace asperity::scenario
{
namespace
{
using Conditions = std::vector<BoundaryCondition>;

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
      if (result.other_side.is_mirrored || condition.may_open) {
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
    } else if (condition.givesSlipRate()) {
      prescribeSlipRate(condition, context, result);
    }
  }
  if (result.surface.empty() && !result.tractions.empty()) {
    result.surface = result.tractions.front().boundary;
  }
  return result;
}

template <int Dim>
fem::Boundaries faultsWithFriction(BoundaryConditions<Dim> const& conditions)
{
  auto const& given = conditions.given_slip;
  fem::Boundaries result;
  std::copy_if(conditions.faults.begin(), conditions.faults.end(), std::back_inserter(result),
               [&](std::string const& fault) {
                 return std::find(given.begin(), given.end(), fault) == given.end();
               });
  return result;
}

template fem::Boundaries faultsWithFriction(BoundaryConditions<2> const&);
template fem::Boundaries faultsWithFriction(BoundaryConditions<3> const&);
template BoundaryConditions<2> makeBoundaryConditions(std::vector<BoundaryCondition> const&, int);
template BoundaryConditions<3> makeBoundaryConditions(std::vector<BoundaryCondition> const&, int);
} // namespace asperity::scenario
