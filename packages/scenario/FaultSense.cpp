#include "scenario/FaultSense.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/constraints/PlaneTangent.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
using Vector3 = std::array<double, 3>;

constexpr double level = 1e-6;    // the part of a unit vector that is rounding
constexpr double opposite = 0.05; // of a mean normal: below, parts of the fault face each other

double dot(Vector3 const& a, Vector3 const& b) { return mesh::dot<3>(a, b); }

Vector3 tangentInPlane(Vector3 const& plus)
{
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

std::string inSpace(FaultSides const& sides)
{
  const double above = dot(sides.plus, sides.up);
  Vector3 strike = mesh::cross(sides.up, sides.plus);
  const double length = std::sqrt(dot(strike, strike));
  std::string text = "slip has parts along the axes";
  if (length < level) {
    return text + "; the fault is level";
  }
  for (double& component : strike) {
    component /= -length; // to the right of who looks at the plus side
  }
  text += "; along " + directionText(strike, 3) + " it is right lateral";
  if (std::abs(above) > level) {
    text += std::string(", upwards ") + (above > 0 ? "a thrust" : "that of a normal fault");
  }
  return text;
}
} // namespace

std::string senseInWords(FaultSides const& sides, double slip)
{
  if (sides.components == 1) {
    if (std::abs(sides.plus[0]) < level) {
      return "neither left nor right lateral, as the fault is level";
    }
    return lateral({0, 0, slip}, sides.plus, {0, 1, 0}) + " seen from above";
  }
  Vector3 motion = tangentInPlane(sides.plus);
  for (double& component : motion) {
    component *= slip;
  }
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
    return inSpace(sides);
  }
  const std::string moves = "positive slip moves it along ";
  if (sides.components == 1) {
    return moves + "+z, out of the plane: " + senseInWords(sides, 1);
  }
  return moves + directionText(tangentInPlane(sides.plus), 2) + ": " + senseInWords(sides, 1);
}

namespace
{
// Gravity acts in the plane of a section, and says where up is.
void standUpright(FaultSides& sides, ParameterList const& bulk)
{
  auto const down = bulk.get<Teuchos::Array<double>>("Gravity Direction");
  const double length = down.size() < 2 ? 0 : std::hypot(down[0], down[1]);
  sides.is_section =
    sides.components == 2 && bulk.get<double>("Gravitational Acceleration") > 0 && length > 0;
  if (sides.is_section) {
    sides.up = {-down[0] / length, -down[1] / length, 0};
  }
}
} // namespace

template <int Dim>
std::vector<std::string> describeSense(Problem<Dim> const& problem, ParameterList const& deck)
{
  auto const& fault = *problem.surface;
  std::vector<double> sums(4, 0.); // of weighted normals towards the plus side, and of plate rates
  for (int i = 0; i < fault.numNodes(); ++i) {
    for (int d = 0; d < 3; ++d) {
      sums[d] -= fault[i].weight * fault[i].normal[d]; // out of the body, which is plus
    }
    sums[3] += fault[i].weight * fault.plateRate(i, 0);
  }
  sums = sumOverRanks(sums, *problem.communicator);
  FaultSides sides{{sums[0], sums[1], sums[2]}, Dim, problem.components};
  const double size = std::sqrt(dot(sides.plus, sides.plus));
  if (size == 0 || !(size > opposite * fault.totalWeight())) { // or there is no fault
    return {};
  }
  for (double& component : sides.plus) {
    component /= size;
  }
  if (Dim == 2) {
    standUpright(sides, deck.sublist("Bulk"));
  }
  auto const& output = deck.sublist("Output");
  if (Dim == 3 && output.isParameter("Up")) {
    auto const up = output.get<Teuchos::Array<double>>("Up");
    std::copy(up.begin(), up.end(), sides.up.begin());
  }
  std::vector<std::string> lines{"Fault '" + fault.name() + "': its plus side" +
                                 (fault.otherSide().is_inside ? "" : ", the body,") +
                                 " lies towards " + directionText(sides.plus, Dim) + "; " +
                                 senseOfSlip(sides) + "."};
  if (Dim == 2 && fault.hasPlateRate() && sums[3] != 0) {
    const double rate = sums[3] / fault.totalWeight();
    lines.push_back("The plates slip along it at " + formatShort(rate) +
                    " m/s on the average: " + senseInWords(sides, rate) + ".");
  }
  return lines;
}

template std::vector<std::string> describeSense(Problem<2> const&, ParameterList const&);
template std::vector<std::string> describeSense(Problem<3> const&, ParameterList const&);
} // namespace asperity::scenario
