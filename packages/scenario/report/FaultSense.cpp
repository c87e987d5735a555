#include "scenario/report/FaultSense.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "fem/constraints/PlaneTangent.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace asperity::scenario
{
namespace
{
using Vector3 = std::array<double, 3>;

constexpr double level = 1e-6;    // the part of a unit vector that is rounding
constexpr double opposite = 0.05; // of a mean normal: below, parts of the fault face each other

double dot(Vector3 const& a, Vector3 const& b) { return mesh::dot<3>(a, b); }

double length(Vector3 const& v) { return std::sqrt(dot(v, v)); }

Vector3 scaled(Vector3 v, double factor)
{
  for (double& component : v) {
    component *= factor;
  }
  return v;
}

Vector3 across(Vector3 const& v, Vector3 const& unit)
{
  return mesh::difference<3>(v, scaled(unit, dot(v, unit)));
}

Vector3 tangentOf(FaultSides const& sides)
{
  if (length(sides.tangent) > 0) {
    return sides.tangent;
  }
  auto const [x, y] = fem::tangentInPlane(sides.plus[0], sides.plus[1]);
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

StrikeAndDip strikeAndDip(FaultSides const& sides)
{
  if (length(mesh::cross(sides.up, sides.plus)) < level) {
    return {true, 0, 0};
  }
  auto const wall = hangingWall(sides);
  Vector3 east = across(sides.east, sides.up);
  for (int axis = 0; axis < 3 && length(east) < level; ++axis) { // East is along Up
    Vector3 other{};
    other[axis] = 1;
    east = across(other, sides.up);
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
  if (strikeAndDip(sides).is_level || length(across(slip, sides.plus)) < level * length(slip) ||
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
  auto const motion = scaled(tangentOf(sides), slip);
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
  return moves + directionText(tangentOf(sides), 2) + ": " + senseInWords(sides, 1);
}

namespace
{
// What is known of a fault from its facets and nodes.
struct MeanFault
{
  FaultSides sides;
  bool has_sides = false; // its parts do not face each other
  Vector3 plates{};       // their mean slip rate along it [m/s]
};

template <int Dim>
MeanFault meanOf(Problem<Dim> const& problem, std::string const& name)
{
  auto const& surface = problem.surface();
  auto const normal = fem::integrateNormal(problem.mesh(), {name}, *problem.communicator);
  MeanFault fault{{scaled(normal.normal, -1), Dim, problem.components()}};
  fault.has_sides = length(normal.normal) > opposite * normal.measure;
  if (!fault.has_sides) {
    return fault;
  }
  fault.sides.plus = scaled(fault.sides.plus, 1 / length(normal.normal));
  std::vector<double> sums(7, 0.); // of weighted tangents, plate rates and weights
  auto const vertices = mesh::boundaryVertices(problem.mesh(), name);
  for (const int vertex : vertices) {
    const int node = vertex < problem.mesh().num_owned ? surface.nodeAt(vertex) : -1;
    for (int k = 0; node >= 0 && k < surface.numTangents(); ++k) {
      const double weight = surface[node].weight;
      for (int d = 0; d < 3; ++d) {
        sums[d] += k == 0 ? weight * surface[node].tangents[k][d] : 0;
        sums[3 + d] += weight * surface.plateRate(node, k) * surface[node].tangents[k][d];
      }
      sums[6] += k == 0 ? weight : 0;
    }
  }
  sums = sumOverRanks(sums, *problem.communicator);
  fault.plates = scaled({sums[3], sums[4], sums[5]}, sums[6] > 0 ? 1 / sums[6] : 0);
  const Vector3 tangent = {sums[0], sums[1], sums[2]};
  if (Dim == 2 && problem.components() == 2 && length(tangent) > 0) {
    fault.sides.tangent = scaled(tangent, 1 / length(tangent));
  }
  fault.sides.is_section = problem.components() == 2 && problem.settings.bulk.hasGravity();
  // Without gravity a plane may be a map; then +y counts as up in a section.
  fault.sides.up = fault.sides.is_section ? scaled(problem.discretisation.upright.down, -1)
                   : Dim == 2 && problem.components() == 2 ? Vector3{0, 1, 0}
                                                           : problem.discretisation.upright.up;
  auto const& east = problem.settings.east.east;
  std::copy_n(east.begin(), std::min<std::size_t>(3, east.size()), fault.sides.east.begin());
  return fault;
}

// The rake of what the entry says, if a direction says where it points.
std::string rakeAlong(FaultSides const& sides, std::optional<std::vector<double>> const& direction,
                      char const* entry)
{
  if (!direction) {
    return "";
  }
  Vector3 towards{};
  std::copy_n(direction->begin(), std::min<std::size_t>(3, direction->size()), towards.begin());
  auto const rake = rakeInWords(sides, towards);
  return rake.empty() ? "" : std::string("; a positive ") + entry + " has " + rake;
}

// In space: of prescribed slip, or else of the shear traction that friction bears.
template <int Dim>
std::string describeRake(FaultSides const& sides, Problem<Dim> const& problem,
                         std::string const& fault)
{
  auto const& given = problem.discretisation.boundary.given_slip;
  if (std::find(given.begin(), given.end(), fault) == given.end()) {
    return rakeAlong(sides, problem.settings.friction.slip_direction, "Shear Traction");
  }
  for (auto const& condition : problem.settings.conditions) {
    if (condition.boundary == fault && condition.givesSlipRate()) {
      return rakeAlong(sides, condition.direction, condition_entries::slip_rate);
    }
  }
  return "";
}

// The sense of a fault whose parts face each other. Inside the body such a fault encloses a part of
// it, and its plus side is the outside (mesh::splitFaults); else the body lies all around it, or in
// it.
template <int Dim>
std::string describeRing(Problem<Dim> const& problem)
{
  if (!problem.surface().otherSide().is_inside) {
    return "its plus side is the body";
  }
  return std::string("its plus side is the outside") +
         (Dim == 3                    ? ""
          : problem.components() == 2 ? "; positive slip runs counterclockwise, seen against +z"
                                      : "; positive slip moves it along +z, out of the plane");
}

std::string describePlates(MeanFault const& fault, int dimension)
{
  auto const& sides = fault.sides;
  if (dimension == 3) {
    auto const rake = rakeInWords(sides, fault.plates);
    return "The plates slip along it at " + formatShort(length(fault.plates)) +
           " m/s on the average" + (rake.empty() ? "" : ": " + rake) + ".";
  }
  const double rate = sides.components == 1 ? fault.plates[2] : dot(fault.plates, tangentOf(sides));
  return "The plates slip along it at " + formatShort(rate) +
         " m/s on the average: " + senseInWords(sides, rate) + ".";
}
} // namespace

template <int Dim>
std::vector<std::string> describeSense(Problem<Dim> const& problem)
{
  std::vector<std::string> lines;
  auto const& upright = problem.discretisation.upright;
  if (Dim == 3 || problem.settings.bulk.hasGravity()) {
    std::string line = "Up is " + directionText(upright.up, Dim) + ", " + upright.reason;
    if (problem.settings.bulk.hasGravity()) {
      line += "; gravity points to " + directionText(upright.down, Dim);
    }
    lines.push_back(line + ".");
  }
  auto const& surface = problem.surface();
  for (auto const& name : problem.discretisation.boundary.faults) {
    auto const fault = meanOf(problem, name);
    if (!fault.has_sides) {
      lines.push_back("Fault '" + name + "': " + describeRing(problem) + ".");
      continue;
    }
    lines.push_back("Fault '" + name + "': its plus side" +
                    (surface.otherSide().is_inside ? "" : ", the body,") + " lies towards " +
                    directionText(fault.sides.plus, Dim) + "; " + senseOfSlip(fault.sides) +
                    (Dim == 3 ? describeRake(fault.sides, problem, name) : "") + ".");
    if (surface.hasPlateRate() && length(fault.plates) > 0) {
      lines.push_back(describePlates(fault, Dim));
    }
  }
  return lines;
}

template <int Dim>
bool haveOneSense(Problem<Dim> const& problem)
{
  std::optional<FaultSides> first;
  for (auto const& name : problem.discretisation.boundary.faults) {
    auto const fault = meanOf(problem, name);
    if (!fault.has_sides) {
      continue;
    }
    if (!first) {
      first = fault.sides;
    } else if (Dim == 3 ? dot(first->plus, fault.sides.plus) < 0
                        : senseInWords(*first, 1) != senseInWords(fault.sides, 1)) {
      return false;
    }
  }
  return true;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::vector<std::string> describeSense(Problem<Dim> const&);                            \
  template bool haveOneSense(Problem<Dim> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
