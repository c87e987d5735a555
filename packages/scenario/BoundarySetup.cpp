#include "scenario/BoundarySetup.hpp"

#include "base/Field.hpp"

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
} // namespace

RCP<const ParameterList> boundaryParameters()
{
  auto const one =
    Declare()
      .text("Boundary", required, "Name of the boundary in the mesh.")
      .choice("Type", required,
              {"Friction", "Prescribed Velocity", "Sliding Wall", "Fixed", "Free Surface"},
              "Friction: rate-and-state friction in bilateral contact with a rigid foundation (v . "
              "n = 0). "
              "Prescribed Velocity: in one direction, free across it. Sliding Wall: v . n = 0, "
              "free along it. "
              "Fixed: v = 0. Free Surface: no traction, the default, named so that its motion can "
              "be written.")
      .realArray(
        "Direction", std::vector<double>{1., 0.}, "-", Range::any(),
        "Direction of a prescribed velocity in x and y, of any length; antiplane has only one.")
      .field("Velocity", 0., "m/s", Range::any(), "Prescribed velocity in that direction.")
      .real("Ramp Duration", 0., "s", Range::atLeast(0),
            "Time over which the prescribed velocity grows smoothly from zero.")
      .list();
  return Declare()
    .sublist("<condition>", one, "One boundary condition; the name is the user's.")
    .list();
}

BoundaryConditions makeBoundaryConditions(ParameterList const& list, int components)
{
  BoundaryConditions result;
  std::map<std::string, std::string>
    exclusive; // boundary -> name of a condition that leaves no room for others
  std::map<std::string, std::string> any;
  for (auto const& entry : list) {
    auto const& condition = list.sublist(entry.first);
    auto const name = joinPath(path, entry.first);
    auto const type = condition.get<std::string>("Type");
    auto const boundary = condition.get<std::string>("Boundary");
    const bool leaves_no_room = type == "Free Surface" || type == "Fixed";
    auto const other = leaves_no_room ? any.find(boundary) : exclusive.find(boundary);
    ASPERITY_REQUIRE(other == (leaves_no_room ? any.end() : exclusive.end()),
                     name << " (" << type << ") contradicts " << other->second
                          << " on the boundary '" << boundary << "'. Remove one of them.");
    any[boundary] = name;
    if (leaves_no_room) {
      exclusive[boundary] = name;
    }
    if (type == "Friction") {
      ASPERITY_REQUIRE(result.fault.empty(), name << ": there is already friction on the boundary '"
                                                  << result.fault
                                                  << "'. One boundary can have it.");
      result.fault = boundary;
      if (components == 2) {
        // The contact comes first, so that the frames of its nodes follow the fault.
        result.velocities.insert(result.velocities.begin(), {name, boundary, {}, {}});
      }
    } else if (type == "Sliding Wall") {
      if (components == 2) {
        result.velocities.push_back({name, boundary, {}, {}});
      }
    } else if (type == "Fixed") {
      for (int c = 0; c < components; ++c) {
        result.velocities.push_back({name, boundary, axis(components, c), {}});
      }
    } else if (type == "Prescribed Velocity") {
      result.velocities.push_back(prescribed(condition, name, components));
      result.ramp_end = std::max(result.ramp_end, condition.get<double>("Ramp Duration"));
    } else if (result.surface.empty()) {
      result.surface = boundary;
    }
  }
  ASPERITY_REQUIRE(
    !result.fault.empty(),
    path << " has no condition of Type 'Friction'. Name the boundary that is the fault.");
  return result;
}
} // namespace asperity::scenario
