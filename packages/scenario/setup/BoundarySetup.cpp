#include "scenario/setup/BoundarySetup.hpp"

#include "base/fields/Field.hpp"
#include "scenario/setup/BoundaryChecks.hpp"
#include "scenario/setup/NodalField.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Boundary Conditions";

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

// Where there is but one direction to move in.
void refuseDirection(ParameterList const& list, std::string const& name, char const* only)
{
  ASPERITY_REQUIRE(!isGiven(list, "Direction"), joinPath(name, "Direction")
                                                  << " has no effect: " << only << ". Remove it.");
}

std::vector<double> directionOf(ParameterList const& list, std::string const& name, int components)
{
  if (components == 1) {
    refuseDirection(list, name, "an antiplane body moves along z alone");
    return {1.};
  }
  if (!isGiven(list, "Direction")) {
    return axis(components, 0);
  }
  auto const given = list.get<Teuchos::Array<double>>("Direction").toVector();
  double square = 0;
  for (double component : given) {
    square += component * component;
  }
  ASPERITY_REQUIRE(static_cast<int>(given.size()) == components && square > 0,
                   joinPath(name, "Direction")
                     << " needs "
                     << (components == 3
                           ? "three numbers, not all zero: where the velocity points, "
                             "in x, y and z."
                           : "two numbers, not both zero: where the velocity points, "
                             "in x and y."));
  return given;
}

std::shared_ptr<const Field> fieldOr(double standard, ParameterList const& list,
                                     std::string const& entry, std::string const& name)
{
  return std::make_shared<Field>(isGiven(list, entry)
                                   ? Field(list, entry, name, std::vector<std::string>{})
                                   : Field::constant(standard));
}

double rampDuration(ParameterList const& list)
{
  return isGiven(list, "Ramp Duration") ? list.get<double>("Ramp Duration") : 0;
}

bool isDriven(ParameterList const& list)
{
  return isGiven(list, "Velocity") &&
         !(list.isType<double>("Velocity") && list.get<double>("Velocity") == 0);
}

template <int Dim>
fem::VelocityCondition<Dim> prescribed(ParameterList const& list, std::string const& name,
                                       int components)
{
  auto const velocity = fieldOr(0, list, "Velocity", name);
  const double duration = rampDuration(list);
  fem::VelocityCondition<Dim> condition;
  condition.name = name;
  condition.boundary = list.get<std::string>("Boundary");
  condition.direction = directionOf(list, name, components);
  condition.velocity = [velocity, duration](Point<Dim> const& x, double t) {
    return ramp(t, duration) * (*velocity)(inSpace<Dim>(x), t, 0);
  };
  return condition;
}

// In three dimensions: where a boundary that is driven meets the fault, friction does not move it
// sideways. It could hardly, and it knows the direction of slip only where nothing else drives.
fem::VelocityCondition<3> notSideways(fem::VelocityCondition<3> const& driven,
                                      std::string const& fault)
{
  fem::VelocityCondition<3> condition;
  condition.name = driven.name;
  condition.boundary = fault;
  condition.meeting = driven.boundary;
  condition.tangential = true;
  condition.towards = driven.direction;
  condition.at_right_angles = true;
  return condition;
}

using Conditions = std::vector<BoundaryCondition>;

template <int Dim>
void findFault(Conditions const& conditions, BoundaryConditions<Dim>& result)
{
  for (auto const& condition : conditions) {
    if (condition.isFault()) {
      ASPERITY_REQUIRE(result.fault.empty(), condition.name
                                               << ": there is already friction on the boundary '"
                                               << result.fault << "'. One boundary can have it.");
      result.fault = condition.boundary();
      result.antisymmetric = condition.type() == "Antisymmetric Fault";
    }
  }
  ASPERITY_REQUIRE(!result.fault.empty(),
                   path << " has no condition of Type 'Bilateral Contact' or 'Antisymmetric "
                           "Fault'. Name the boundary that is the fault.");
}

std::vector<std::string> faultAndContinuations(Conditions const& conditions)
{
  std::vector<std::string> boundaries;
  for (auto const& condition : conditions) {
    if (condition.liesAlongFault()) {
      boundaries.push_back(condition.boundary());
    }
  }
  return boundaries;
}

// The fault comes first, then what continues it, so that the frames of their nodes follow them and
// have the same normal where they meet.
template <int Dim>
void layAlongFault(Conditions const& conditions, BoundaryConditions<Dim>& result)
{
  auto const boundaries = faultAndContinuations(conditions);
  auto& velocities = result.velocities;
  for (auto const& condition : conditions) {
    if (condition.liesAlongFault()) {
      fem::VelocityCondition<Dim> across = {condition.name, condition.boundary(), {}, {}};
      across.free = result.antisymmetric;
      across.continued_by = boundaries;
      velocities.insert(condition.isFault() ? velocities.begin() : velocities.end(), across);
    }
  }
}

// v_t = slip rate / slip factor: along the tangent of the frames, in three dimensions along the
// projection of the direction onto the boundary, and none at right angles to it.
template <int Dim>
std::vector<fem::VelocityCondition<Dim>>
slipping(ParameterList const& list, std::string const& name,
         std::vector<std::string> const& fault_and_continuations, double factor, int components)
{
  ASPERITY_REQUIRE(isGiven(list, "Slip Rate"),
                   joinPath(name, "Slip Rate") << " is missing: at which rate the continuation of "
                                                  "the fault slips, 0 if it is locked.");
  auto const rate = std::make_shared<Field>(list, "Slip Rate", name, std::vector<std::string>{});
  fem::VelocityCondition<Dim> condition;
  condition.name = name;
  condition.boundary = list.get<std::string>("Boundary");
  condition.velocity = [rate, factor](Point<Dim> const& x, double t) {
    return (*rate)(inSpace<Dim>(x), t, 0) / factor;
  };
  if (components < 3) {
    refuseDirection(list, name, "in two dimensions a fault slips along its tangent");
  }
  if (components == 1) {
    condition.direction = {1};
    return {condition};
  }
  condition.tangential = true;
  condition.continued_by = fault_and_continuations;
  if (components == 2) {
    return {condition};
  }
  condition.towards = directionOf(list, name, components);
  auto sideways = condition;
  sideways.at_right_angles = true;
  sideways.velocity = {};
  return {condition, sideways};
}
} // namespace

RCP<const ParameterList> boundaryParameters()
{
  auto const one =
    Declare()
      .text("Boundary", required, "Name of the boundary in the mesh.")
      .choice("Type", required,
              {"Bilateral Contact", "Antisymmetric Fault", "Prescribed Slip Rate",
               "Prescribed Velocity", "Absorbing", "Sliding Wall", "Fixed", "Free Surface"},
              "Bilateral Contact: rate-and-state friction on a rigid foundation (v . n = 0). "
              "Antisymmetric Fault: the same on a planar fault of which the body is one half; the "
              "slip is twice its tangential displacement, the displacement across the fault is "
              "free and the normal stress unchanged. "
              "Prescribed Slip Rate: continues the fault, and slips at that rate. "
              "Prescribed Velocity: in one direction, free across it. "
              "Absorbing: dashpots that take up waves. Sliding Wall: v . n = 0, free along it. "
              "Fixed: v = 0. Free Surface: no traction, the default, named so that its motion can "
              "be written.")
      .realArray(
        "Direction", optional, "-", Range::any(),
        "Prescribed Velocity: its direction along the axes, of any length, +x if left out; "
        "antiplane has only one. Prescribed Slip Rate in three dimensions: the same, "
        "projected onto the boundary.")
      .field("Velocity", optional, "m/s", Range::any(),
             "Prescribed Velocity: how fast in that direction; zero if left out.")
      .real("Ramp Duration", optional, "s", Range::atLeast(0),
            "Prescribed Velocity: the time over which it grows smoothly from zero; at once if left "
            "out.")
      .field("Slip Rate", optional, "m/s", Range::any(),
             "Prescribed Slip Rate: the rate, in two dimensions along the tangent of the fault's "
             "frame: along +x on a fault below the body.")
      .list();
  return Declare()
    .sublist("<condition>", one, "One boundary condition; the name is the user's.")
    .list();
}

template <int Dim>
BoundaryConditions<Dim> makeBoundaryConditions(ParameterList const& list, int components)
{
  auto const conditions = readConditions(list);
  refuseUnreadEntries(conditions);
  refuseContradictions(conditions);
  BoundaryConditions<Dim> result;
  findFault(conditions, result);
  if (components > 1) {
    layAlongFault(conditions, result);
  }
  auto const along = faultAndContinuations(conditions);
  for (auto const& condition : conditions) {
    auto const& name = condition.name;
    auto const type = condition.type();
    auto const boundary = condition.boundary();
    if (condition.hasSlipRate()) {
      auto const slip = slipping<Dim>(condition.list, name, along, result.slipFactor(), components);
      result.velocities.insert(result.velocities.end(), slip.begin(), slip.end());
    } else if (type == "Sliding Wall" && components > 1) {
      result.velocities.push_back({name, boundary, {}, {}});
    } else if (type == "Fixed") {
      for (int c = 0; c < components; ++c) {
        result.velocities.push_back({name, boundary, axis(components, c), {}});
      }
    } else if (type == "Prescribed Velocity") {
      result.velocities.push_back(prescribed<Dim>(condition.list, name, components));
      if constexpr (Dim == 3) {
        if (isDriven(condition.list)) {
          result.velocities.push_back(notSideways(result.velocities.back(), result.fault));
        }
      }
      result.ramp_end = std::max(result.ramp_end, rampDuration(condition.list));
    } else if (type == "Absorbing") {
      result.absorbing.push_back(boundary);
    } else if (type == "Free Surface" && result.surface.empty()) {
      result.surface = boundary;
    }
  }
  return result;
}

template BoundaryConditions<2> makeBoundaryConditions(ParameterList const&, int);
template BoundaryConditions<3> makeBoundaryConditions(ParameterList const&, int);
} // namespace asperity::scenario
