#include "scenario/BoundarySetup.hpp"

#include "base/Field.hpp"
#include "scenario/NodalField.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

std::vector<double> directionOf(ParameterList const& list, std::string const& name, int components)
{
  if (components == 1) {
    return {1.};
  }
  auto const given = list.get<Teuchos::Array<double>>("Direction").toVector();
  ASPERITY_REQUIRE(given.size() == 2 && std::hypot(given[0], given[1]) > 0,
                   joinPath(name, "Direction")
                     << " needs two numbers, not both zero: where the velocity "
                        "points, in x and y.");
  return given;
}

fem::VelocityCondition<2> prescribed(ParameterList const& list, std::string const& name,
                                     int components)
{
  auto const velocity = std::make_shared<Field>(list, "Velocity", name, std::vector<std::string>{});
  const double duration = list.get<double>("Ramp Duration");
  fem::VelocityCondition<2> condition;
  condition.name = name;
  condition.boundary = list.get<std::string>("Boundary");
  condition.direction = directionOf(list, name, components);
  condition.velocity = [velocity, duration](Point<2> const& x, double t) {
    return ramp(t, duration) * (*velocity)({x[0], x[1], 0}, t, 0);
  };
  return condition;
}

// The conditions by name, in the order of the deck.
using Conditions = std::vector<std::pair<std::string, ParameterList>>;

std::string typeOf(ParameterList const& list) { return list.get<std::string>("Type"); }
std::string boundaryOf(ParameterList const& list) { return list.get<std::string>("Boundary"); }
bool isFault(ParameterList const& list)
{
  return typeOf(list) == "Bilateral Contact" || typeOf(list) == "Antisymmetric Fault";
}
bool isSlipRate(ParameterList const& list) { return typeOf(list) == "Prescribed Slip Rate"; }

// A free surface and a fixed boundary have it for themselves.
void refuseContradictions(Conditions const& conditions)
{
  std::map<std::string, std::string> exclusive; // boundary -> name of the condition
  std::map<std::string, std::string> any;
  for (auto const& [name, list] : conditions) {
    auto const type = typeOf(list);
    auto const boundary = boundaryOf(list);
    const bool leaves_no_room = type == "Free Surface" || type == "Fixed";
    auto const other = leaves_no_room ? any.find(boundary) : exclusive.find(boundary);
    ASPERITY_REQUIRE(other == (leaves_no_room ? any.end() : exclusive.end()),
                     name << " (" << type << ") contradicts " << other->second
                          << " on the boundary '" << boundary << "'. Remove one of them.");
    any[boundary] = name;
    if (leaves_no_room) {
      exclusive[boundary] = name;
    }
  }
}

void findFault(Conditions const& conditions, BoundaryConditions& result)
{
  for (auto const& [name, list] : conditions) {
    if (isFault(list)) {
      ASPERITY_REQUIRE(result.fault.empty(), name << ": there is already friction on the boundary '"
                                                  << result.fault
                                                  << "'. One boundary can have it.");
      result.fault = boundaryOf(list);
      result.antisymmetric = typeOf(list) == "Antisymmetric Fault";
    }
  }
  ASPERITY_REQUIRE(!result.fault.empty(),
                   path << " has no condition of Type 'Bilateral Contact' or 'Antisymmetric "
                           "Fault'. Name the boundary that is the fault.");
}

std::vector<std::string> faultAndContinuations(Conditions const& conditions)
{
  std::vector<std::string> boundaries;
  for (auto const& [name, list] : conditions) {
    if (isFault(list) || isSlipRate(list)) {
      boundaries.push_back(boundaryOf(list));
    }
  }
  return boundaries;
}

// The fault comes first, then what continues it, so that the frames of their nodes follow them and
// have the same normal where they meet.
void layAlongFault(Conditions const& conditions, BoundaryConditions& result)
{
  auto const boundaries = faultAndContinuations(conditions);
  auto& velocities = result.velocities;
  for (auto const& [name, list] : conditions) {
    if (isFault(list) || isSlipRate(list)) {
      fem::VelocityCondition<2> across = {name, boundaryOf(list), {}, {}};
      across.free = result.antisymmetric;
      across.continued_by = boundaries;
      velocities.insert(isFault(list) ? velocities.begin() : velocities.end(), across);
    }
  }
}

// v_t = slip rate / slip factor, along the tangent of the frames.
fem::VelocityCondition<2> slipping(ParameterList const& list, std::string const& name,
                                   std::vector<std::string> const& fault_and_continuations,
                                   double factor, int components)
{
  ASPERITY_REQUIRE(isGiven(list, "Slip Rate"),
                   joinPath(name, "Slip Rate") << " is missing: at which rate the continuation of "
                                                  "the fault slips, 0 if it is locked.");
  auto const rate = std::make_shared<Field>(list, "Slip Rate", name, std::vector<std::string>{});
  fem::VelocityCondition<2> condition;
  condition.name = name;
  condition.boundary = boundaryOf(list);
  condition.velocity = [rate, factor](Point<2> const& x, double t) {
    return (*rate)({x[0], x[1], 0}, t, 0) / factor;
  };
  if (components == 1) {
    condition.direction = {1};
    return condition;
  }
  condition.tangential = true;
  condition.continued_by = fault_and_continuations;
  return condition;
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
        "Direction", std::vector<double>{1., 0.}, "-", Range::any(),
        "Direction of a prescribed velocity in x and y, of any length; antiplane has only one.")
      .field("Velocity", 0., "m/s", Range::any(), "Prescribed velocity in that direction.")
      .real("Ramp Duration", 0., "s", Range::atLeast(0),
            "Time over which the prescribed velocity grows smoothly from zero.")
      .field("Slip Rate", optional, "m/s", Range::any(),
             "Prescribed slip rate, along the tangent of the fault's frame: along +x on a fault "
             "below the body.")
      .list();
  return Declare()
    .sublist("<condition>", one, "One boundary condition; the name is the user's.")
    .list();
}

BoundaryConditions makeBoundaryConditions(ParameterList const& list, int components)
{
  Conditions conditions;
  for (auto const& entry : list) {
    conditions.emplace_back(joinPath(path, entry.first), list.sublist(entry.first));
  }
  refuseContradictions(conditions);
  BoundaryConditions result;
  findFault(conditions, result);
  if (components == 2) {
    layAlongFault(conditions, result);
  }
  auto const along = faultAndContinuations(conditions);
  for (auto const& [name, condition] : conditions) {
    auto const type = typeOf(condition);
    auto const boundary = boundaryOf(condition);
    if (isSlipRate(condition)) {
      result.velocities.push_back(
        slipping(condition, name, along, result.slipFactor(), components));
    } else if (type == "Sliding Wall" && components == 2) {
      result.velocities.push_back({name, boundary, {}, {}});
    } else if (type == "Fixed") {
      for (int c = 0; c < components; ++c) {
        result.velocities.push_back({name, boundary, axis(components, c), {}});
      }
    } else if (type == "Prescribed Velocity") {
      result.velocities.push_back(prescribed(condition, name, components));
      result.ramp_end = std::max(result.ramp_end, condition.get<double>("Ramp Duration"));
    } else if (type == "Absorbing") {
      result.absorbing.push_back(boundary);
    } else if (type == "Free Surface" && result.surface.empty()) {
      result.surface = boundary;
    }
  }
  return result;
}
} // namespace asperity::scenario
