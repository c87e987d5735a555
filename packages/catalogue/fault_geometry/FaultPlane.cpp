#include "catalogue/fault_geometry/FaultPlane.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::catalogue
{
namespace
{
double length(Direction const& v) { return std::sqrt(mesh::dot<3>(v, v)); }

Direction scaled(Direction v, double factor)
{
  for (double& component : v) {
    component *= factor;
  }
  return v;
}

Direction unit(Direction const& v) { return scaled(v, 1 / length(v)); }

// The part of v across the unit vector n.
Direction across(Direction const& v, Direction const& n)
{
  return mesh::difference<3>(v, scaled(n, mesh::dot<3>(v, n)));
}

int largestComponent(Direction const& v)
{
  const auto smaller = [](double left, double right) {
    return std::abs(left) < (1 - 1e-9) * std::abs(right); // rounding does not decide
  };
  return static_cast<int>(std::max_element(v.begin(), v.end(), smaller) - v.begin());
}

// The sum over the facets of area times unit normal.
Direction areaNormal(io::OutputDomain const& fault, std::optional<int> boundary)
{
  Direction mine{}, sum{};
  for (std::size_t e = 0; e < fault.numOwnedElements(); ++e) {
    if (boundary && fault.element_boundaries[e] != *boundary) {
      continue;
    }
    std::array<Point<3>, 3> corners;
    for (int k = 0; k < 9; ++k) {
      corners[k / 3][k % 3] = fault.corners[9 * e + k];
    }
    const auto normal = mesh::areaNormal(corners);
    for (int d = 0; d < 3; ++d) {
      mine[d] += normal[d];
    }
  }
  for (int d = 0; d < 3; ++d) {
    sum[d] = sumOverRanks(mine[d], *fault.comm);
  }
  return sum;
}

double smallest(io::OutputDomain const& fault, std::optional<int> boundary, Direction const& along)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    if (!boundary || fault.node_boundaries[i] == *boundary) {
      double const* x = &fault.coordinates[3 * i];
      least = std::min(least, mesh::dot<3>(along, {x[0], x[1], x[2]}));
    }
  }
  return minOverRanks(least, *fault.comm);
}
} // namespace

double FaultPlane::alongStrike(double const* x) const
{
  return mesh::dot<3>(strike, {x[0], x[1], x[2]});
}

double FaultPlane::downDip(double const* x) const
{
  return mesh::dot<3>(dip, {x[0], x[1], x[2]}) - top;
}

FaultPlane faultPlane(io::OutputDomain const& fault, Direction const& up,
                      std::optional<int> boundary)
{
  auto const plane = meanPlane(fault, up, boundary);
  ASPERITY_REQUIRE(plane, "The facets of the fault cancel each other: it has no mean plane. Is it "
                          "a closed surface?");
  return *plane;
}

std::optional<FaultPlane> meanPlane(io::OutputDomain const& fault, Direction const& up,
                                    std::optional<int> boundary)
{
  ASPERITY_ASSERT(fault.dimension == 3 && fault.nodes_per_element == 3);
  constexpr double level = 1e-6; // sine of a dip that is rounding
  FaultPlane plane;
  const auto area = areaNormal(fault, boundary);
  if (!(length(area) > 0)) {
    return {};
  }
  plane.normal = unit(area);
  const Direction upwards = unit(up);
  plane.dip = scaled(across(upwards, plane.normal), -1);
  if (length(plane.dip) < level) {
    Direction axis{};
    axis[(largestComponent(upwards) + 2) % 3] = 1;
    plane.dip = across(axis, plane.normal);
  }
  plane.dip = unit(plane.dip);
  plane.strike = mesh::cross(plane.normal, plane.dip);
  if (plane.strike[largestComponent(plane.strike)] < 0) {
    plane.strike = scaled(plane.strike, -1);
  }
  plane.down = scaled(upwards, -1);
  plane.inward = unit(mesh::cross(plane.strike, plane.down));
  if (mesh::dot<3>(plane.inward, plane.normal) > 0) {
    plane.inward = scaled(plane.inward, -1);
  }
  plane.top = smallest(fault, boundary, plane.dip);
  return plane;
}
} // namespace asperity::catalogue
