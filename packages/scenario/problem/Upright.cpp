#include "scenario/problem/Upright.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity::scenario
{
namespace
{
using Direction = std::array<double, 3>;

constexpr double near_axis = 0.766; // cosine of 40 degrees
constexpr double agreement = 0.5;   // cosine of 60 degrees, more than any slope
constexpr double tilt = 0.866;      // cosine of 30 degrees, of gravity in a tilted sandbox
// A surface faces one way if the integral of its normal has this part of its measure, and more for
// boundaries that are not named as the free surface.
constexpr double faces = 0.5;
constexpr double faces_one_way = 0.9;

double length(Direction const& v) { return std::sqrt(mesh::dot<3>(v, v)); }

std::optional<Direction> unit(Direction v)
{
  const double size = length(v);
  if (!(size > 0)) {
    return std::nullopt;
  }
  for (double& component : v) {
    component /= size;
  }
  return v;
}

// As a unit vector. Empty if it is not given, or is zero, which is refused where it is used.
std::optional<Direction> given(std::optional<std::vector<double>> const& numbers)
{
  if (!numbers) {
    return std::nullopt;
  }
  Direction v{};
  std::copy_n(numbers->begin(), std::min<std::size_t>(3, numbers->size()), v.begin());
  return unit(v);
}

Direction opposite(Direction v)
{
  for (double& component : v) {
    component = 0. - component;
  }
  return v;
}

// The axis that is nearest to a unit vector, in either direction, or the vector itself.
Direction snapped(Direction const& v)
{
  for (int d = 0; d < 3; ++d) {
    if (std::abs(v[d]) >= near_axis) {
      Direction axis{};
      axis[d] = v[d] > 0 ? 1 : -1;
      return axis;
    }
  }
  return v;
}

// "{0, 0, -1}"
std::string entryText(Direction const& v, int dimension)
{
  std::string text;
  for (int d = 0; d < dimension; ++d) {
    text += (d > 0 ? ", " : "{") + formatShort(std::round(1e4 * v[d]) / 1e4 + 0.);
  }
  return text + "}";
}

// The outward normal, if it has this part of the surface's measure.
std::optional<Direction> facing(OuterSurface const& surface, double part)
{
  auto const& [normal, measure] = surface.normal;
  return length(normal) > part * measure ? unit(normal) : std::nullopt;
}

std::string degreesBetween(Direction const& a, Direction const& b)
{
  const double cosine = std::max(-1., std::min(1., mesh::dot<3>(a, b)));
  return formatShort(std::round(std::acos(cosine) * 180 / M_PI)) + " degrees";
}
} // namespace

Upright uprightOf(BulkSettings const& bulk, std::optional<std::vector<double>> const& given_up,
                  int dimension, OuterSurface const& surface, OuterSurface const& open)
{
  auto const names = quotedNames(surface.boundaries);
  const bool has_gravity = bulk.hasGravity();
  auto const up = dimension == 3 ? given(given_up) : std::nullopt;
  auto const down = has_gravity ? given(bulk.gravity_direction) : std::nullopt;
  auto const outward = facing(surface, faces);
  const std::string entry_up = "Asperity / Output / Up",
                    entry_down = "Asperity / Bulk / Gravity Direction";
  if (outward && up) {
    ASPERITY_REQUIRE(mesh::dot<3>(*outward, *up) >= agreement,
                     entry_up << " = " << entryText(*up, dimension) << ", but the free surface "
                              << names << " faces " << entryText(*outward, dimension) << ", "
                              << degreesBetween(*outward, *up)
                              << " from it (at most 60 are allowed). Give "
                              << entryText(snapped(*outward), dimension)
                              << ", or leave it out: up then follows from the free surface.");
  }
  if (outward && down) {
    auto const against = opposite(*down);
    ASPERITY_REQUIRE(
      mesh::dot<3>(*outward, against) >= agreement,
      entry_down << " = " << entryText(*down, dimension) << ", but the free surface " << names
                 << " faces " << entryText(*outward, dimension) << ", "
                 << degreesBetween(*outward, against)
                 << " from the opposite (at most 60 are allowed): the weight of the rock would act "
                    "along its surface. Give "
                 << entryText(opposite(snapped(*outward)), dimension)
                 << ", or leave it out: gravity then points away from the free surface.");
  }
  if (up && down) {
    ASPERITY_REQUIRE(mesh::dot<3>(*up, opposite(*down)) >= tilt,
                     entry_down << " = " << entryText(*down, dimension) << ", but " << entry_up
                                << " = " << entryText(*up, dimension) << " is "
                                << degreesBetween(*up, opposite(*down))
                                << " from the opposite of it (at most 30 are allowed). Leave one "
                                   "of them out: it then follows from the other.");
  }
  auto const of_open = dimension == 3 && has_gravity ? facing(open, faces_one_way) : std::nullopt;
  Upright result;
  result.is_known = up || outward || down || of_open;
  if (up) {
    result.up = *up;
    result.reason = "as Output / Up says";
  } else if (outward) {
    result.up = snapped(*outward);
    result.reason = "where the free surface " + names + " faces";
  } else if (down) {
    result.up = snapped(opposite(*down));
    result.reason = "against gravity";
  } else if (of_open) {
    result.up = snapped(*of_open);
    result.reason = "where " + quotedNames(open.boundaries) + " faces, which nothing holds";
  } else {
    result.reason = "by default";
  }
  result.down = down ? *down : opposite(result.up);
  return result;
}

std::optional<Warning> warnOfUp(BulkSettings const& bulk, int dimension, Upright const& upright)
{
  if (dimension < 3 || !bulk.hasGravity() || upright.is_known) {
    return std::nullopt;
  }
  return Warning{
    "direction of up",
    "Gravity acts, and nothing says which way is up: it is taken as " + entryText(upright.up, 3) +
      ". Elsewhere the weight of the rock would act along its surface. Give the surface the Type "
      "Free Surface, or give Bulk / Gravity Direction or Output / Up."};
}
} // namespace asperity::scenario
