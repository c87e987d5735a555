#include "scenario/report/FaultDescription.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/faults/Facing.hpp"
#include "scenario/report/FaultSense.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace asperity::scenario
{
namespace
{
// What is known of a fault from its facets and nodes.
struct MeanFault
{
  FaultSides sides;
  bool has_sides = false; // it has a mean normal, and is no ring
  Vector3 plates{};       // their mean slip rate along it [m/s]
};

// Sets the means over the nodes: the tangent, where the fault is one line in plane strain whose
// parts do not face each other, and the slip rate of the plates.
template <int Dim>
void setMeans(Problem<Dim> const& problem, std::string const& name, bool has_tangent,
              MeanFault& fault)
{
  auto const& surface = problem.surface();
  std::array<double, 7> sums{}; // of weighted tangents, plate rates and weights
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
  if (has_tangent && length(tangent) > 0) {
    fault.sides.tangent = scaled(tangent, 1 / length(tangent));
  }
}

template <int Dim>
MeanFault meanOf(Problem<Dim> const& problem, std::string const& name)
{
  const bool is_plane_strain = Dim == 2 && problem.components() == 2;
  auto const facing = mesh::facingOf(problem.mesh(), {name}, *problem.communicator);
  MeanFault fault{{scaled(facing.normal, -1), Dim, problem.components()}};
  fault.has_sides = facing.hasMeanNormal() && !facing.isRing();
  if (!fault.has_sides) {
    return fault;
  }
  auto& sides = fault.sides;
  sides.plus = scaled(sides.plus, 1 / length(facing.normal));
  setMeans(problem, name, is_plane_strain && !facing.partsFaceEachOther(), fault);
  sides.is_section = problem.components() == 2 && problem.settings.bulk.hasGravity();
  // Without gravity a plane may be a map; then +y counts as up in a section.
  sides.up = sides.is_section  ? scaled(problem.discretisation.upright.down, -1)
             : is_plane_strain ? Vector3{0, 1, 0}
                               : problem.discretisation.upright.up;
  auto const& east = problem.settings.east.east;
  std::copy_n(east.begin(), std::min<std::size_t>(3, east.size()), sides.east.begin());
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
    return rakeAlong(sides, problem.settings.friction.slip_direction,
                     friction_entries::shear_traction);
  }
  for (auto const& condition : problem.settings.conditions) {
    if (condition.boundary == fault && condition.givesSlipRate()) {
      return rakeAlong(sides, condition.direction, condition_entries::slip_rate);
    }
  }
  return "";
}

// The sense of a ring. Inside the body it encloses a part of it, and its plus side is the outside
// (mesh::splitFaults); else the body lies all around it, or in it.
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
  const double rate =
    sides.components == 1 ? fault.plates[2] : dot(fault.plates, sides.slipTangent());
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
