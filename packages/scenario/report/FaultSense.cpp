#include "scenario/report/FaultSense.hpp"

#include "base/Text.hpp"
#include "fem/constraints/PlaneTangent.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::scenario
{
namespace
{
constexpr double level = 1e-6; // the part of a unit vector that is rounding

// Right lateral: seen from the minus side, the plus side moves to the right.
std::string lateral(Vector3 const& motion, Vector3 const& plus, Vector3 const& up)
{
  return dot(motion, mesh::cross(plus, up)) > 0 ? "right lateral" : "left lateral";
}

// The sense of a motion [m/s] of the plus side that has a vertical part.
std::string dipSlip(FaultSides const& sides, Vector3 const& motion)
{
  const double rise = dot(motion, sides.up), above = dot(sides.plus, sides.up);
  if (std::abs(above) < level) {
    return rise > 0 ? "the plus side up" : "the plus side down";
  }
  return rise * above > 0 ? "a thrust" : "a normal fault";
}

std::string degrees(double angle) { return formatShort(std::round(10 * angle) / 10 + 0.); }

// The unit normal towards the hanging wall, and the unit vectors along strike and up dip.
struct Wall
{
  Vector3 normal, strike, up_dip;
};

Wall hangingWall(FaultSides const& sides)
{
  Wall wall;
  wall.normal = dot(sides.plus, sides.up) < -level ? scaled(sides.plus, -1) : sides.plus;
  wall.strike = mesh::cross(sides.up, wall.normal);
  wall.strike = scaled(wall.strike, 1 / length(wall.strike));
  wall.up_dip = mesh::cross(wall.normal, wall.strike);
  return wall;
}

std::string describeInSpace(FaultSides const& sides)
{
  auto const at = strikeAndDip(sides);
  std::string text = "slip has parts along the axes";
  if (at.is_level) {
    return text + "; the fault is level";
  }
  const double above = dot(sides.plus, sides.up);
  auto const wall = hangingWall(sides);
  // Slip of the plus side along this vector is right lateral, see lateral().
  auto const right = scaled(wall.strike, std::abs(above) <= level || above > 0 ? -1 : 1);
  text += "; strike " + degrees(at.strike) + ", dip " + degrees(at.dip) + "; along " +
          directionText(right, 3) + " it is right lateral";
  if (std::abs(above) > level) {
    text += std::string(", upwards ") + (above > 0 ? "a thrust" : "that of a normal fault");
  }
  return text;
}
} // namespace

Vector3 FaultSides::slipTangent() const
{
  if (length(tangent) > 0) {
    return tangent;
  }
  auto const [x, y] = fem::tangentInPlane(plus[0], plus[1]);
  return {x, y, 0};
}

std::string directionText(Vector3 const& v, int dimension)
{
  std::vector<double> rounded;
  for (int d = 0; d < dimension; ++d) {
    rounded.push_back(std::round(100 * v[d]) / 100 + 0.); // not -0
  }
  return formatPoint(rounded);
}

StrikeAndDip strikeAndDip(FaultSides const& sides)
{
  if (length(mesh::cross(sides.up, sides.plus)) < level) {
    return {true, 0, 0};
  }
  auto const wall = hangingWall(sides);
  Vector3 east = partAcross(sides.east, sides.up);
  for (int axis = 0; axis < 3 && length(east) < level; ++axis) { // East is along Up
    Vector3 other{};
    other[axis] = 1;
    east = partAcross(other, sides.up);
  }
  Vector3 const north = mesh::cross(sides.up, east);
  const double angle = std::atan2(dot(wall.strike, east), dot(wall.strike, north)) * 180 / M_PI;
  const double sine = std::min(1., std::abs(dot(wall.normal, sides.up)));
  return {false, angle < -1e-9 ? angle + 360 : std::abs(angle), std::acos(sine) * 180 / M_PI};
}

double rakeOf(FaultSides const& sides, Vector3 const& slip)
{
  auto const wall = hangingWall(sides);
  const double sign = dot(wall.normal, sides.plus); // of the wall's motion in that of the plus side
  const double along = sign * dot(slip, wall.strike), rise = sign * dot(slip, wall.up_dip);
  const bool is_along = std::abs(rise) < level * std::abs(along); // rounding is not -180 degrees
  return std::atan2(is_along ? 0. : rise, along) * 180 / M_PI;
}

std::string rakeInWords(FaultSides const& sides, Vector3 const& slip)
{
  if (strikeAndDip(sides).is_level || length(partAcross(slip, sides.plus)) < level * length(slip) ||
      length(slip) == 0) {
    return "";
  }
  const double rake = rakeOf(sides, slip), angle = rake * M_PI / 180;
  constexpr double small = 0.05; // parts that are not worth a word
  std::string text = "rake " + degrees(rake) + ", ";
  if (std::abs(std::cos(angle)) > small) {
    text += std::cos(angle) > 0 ? "left lateral" : "right lateral";
    text += std::abs(std::sin(angle)) > small ? " and " : "";
  }
  if (std::abs(std::sin(angle)) > small) {
    const bool vertical = std::abs(dot(sides.plus, sides.up)) <= level;
    text += vertical ? (std::sin(angle) > 0 ? "the plus side up" : "the plus side down")
                     : (std::sin(angle) > 0 ? "a thrust" : "a normal fault");
  }
  return text;
}

std::string senseInWords(FaultSides const& sides, double slip)
{
  if (sides.components == 1) {
    if (length(mesh::cross(sides.plus, sides.up)) < level) {
      return "neither left nor right lateral, as the fault is level";
    }
    return lateral({0, 0, slip}, sides.plus, sides.up) + " seen from above";
  }
  auto const motion = scaled(sides.slipTangent(), slip);
  if (sides.is_section) {
    return std::abs(dot(motion, sides.up)) < level * std::abs(slip) ? "neither up nor down"
                                                                    : dipSlip(sides, motion);
  }
  const std::string in_map = lateral(motion, sides.plus, {0, 0, 1}) + " in a map";
  return std::abs(motion[1]) < level * std::abs(slip)
           ? in_map
           : dipSlip(sides, motion) + " in a section, " + in_map;
}

std::string senseOfSlip(FaultSides const& sides)
{
  if (sides.dimension == 3) {
    return describeInSpace(sides);
  }
  const std::string moves = "positive slip moves it along ";
  if (sides.components == 1) {
    return moves + "+z, out of the plane: " + senseInWords(sides, 1);
  }
  return moves + directionText(sides.slipTangent(), 2) + ": " + senseInWords(sides, 1);
}
} // namespace asperity::scenario
