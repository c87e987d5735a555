#include "scenario/problem/Upright.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "io/OutputSet.hpp"
#include "scenario/setup/DeckDirections.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity::scenario
{
namespace
{
constexpr double near_axis = 0.766; // cosine of 40 degrees
constexpr double agreement = 0.5;   // cosine of 60 degrees, more than any slope
constexpr double tilt = 0.866;      // cosine of 30 degrees, of gravity in a tilted sandbox
// A surface faces one way if the integral of its normal has this part of its measure, and more for
// boundaries that are not named as the free surface.
constexpr double faces = 0.5;
constexpr double faces_one_way = 0.9;

std::optional<Vector3> unit(Vector3 v)
{
  const double size = length(v);
  if (!(size > 0)) {
    return std::nullopt;
  }
  for (double& component : v) { // not times 1 / size, which rounds
    component /= size;
  }
  return v;
}

// As a unit vector. Empty if it is not given, or is zero, which is refused where it is used.
std::optional<Vector3> given(std::optional<std::vector<double>> const& numbers)
{
  if (!numbers) {
    return std::nullopt;
  }
  Vector3 v{};
  std::copy_n(numbers->begin(), std::min<std::size_t>(3, numbers->size()), v.begin());
  return unit(v);
}

Vector3 opposite(Vector3 v)
{
  for (double& component : v) {
    component = 0. - component;
  }
  return v;
}

// The axis that is nearest to a unit vector, in either direction, or the vector itself.
Vector3 snapped(Vector3 const& v)
{
  for (int d = 0; d < 3; ++d) {
    if (std::abs(v[d]) >= near_axis) {
      Vector3 axis{};
      axis[d] = v[d] > 0 ? 1 : -1;
      return axis;
    }
  }
  return v;
}

// "{0, 0, -1}"
std::string entryText(Vector3 const& v, int dimension)
{
  std::string text;
  for (int d = 0; d < dimension; ++d) {
    text += (d > 0 ? ", " : "{") + formatShort(std::round(1e4 * v[d]) / 1e4 + 0.);
  }
  return text + "}";
}

// The outward normal, if it has this part of the surface's measure.
std::optional<Vector3> facing(OuterSurface const& surface, double part)
{
  auto const& [normal, measure] = surface.normal;
  return length(normal) > part * measure ? unit(normal) : std::nullopt;
}

std::string degreesBetween(Vector3 const& a, Vector3 const& b)
{
  const double cosine = std::max(-1., std::min(1., dot(a, b)));
  return formatShort(std::round(std::acos(cosine) * 180 / M_PI)) + " degrees";
}

// The directions that the deck gives, and that in which the free surface faces.
struct Known
{
  int dimension;
  std::string surface; // its names
  std::optional<Vector3> up, outward, down;
};

std::string entryOfUp() { return joinPath(output_path, io::DirectionUp::entry); }
std::string entryOfDown() { return joinPath(bulk_path, gravity_direction_entry); }

void requireUpOutOfSurface(Known const& known)
{
  auto const& [dimension, surface, up, outward, down] = known;
  if (!outward || !up) {
    return;
  }
  ASPERITY_REQUIRE(dot(*outward, *up) >= agreement,
                   entryOfUp() << " = " << entryText(*up, dimension) << ", but the free surface "
                               << surface << " faces " << entryText(*outward, dimension) << ", "
                               << degreesBetween(*outward, *up)
                               << " from it (at most 60 are allowed). Give "
                               << entryText(snapped(*outward), dimension)
                               << ", or leave it out: up then follows from the free surface.");
}

void requireDownIntoSurface(Known const& known)
{
  auto const& [dimension, surface, up, outward, down] = known;
  if (!outward || !down) {
    return;
  }
  auto const against = opposite(*down);
  ASPERITY_REQUIRE(
    dot(*outward, against) >= agreement,
    entryOfDown() << " = " << entryText(*down, dimension) << ", but the free surface " << surface
                  << " faces " << entryText(*outward, dimension) << ", "
                  << degreesBetween(*outward, against)
                  << " from the opposite (at most 60 are allowed): the weight of the rock would "
                     "act along its surface. Give "
                  << entryText(opposite(snapped(*outward)), dimension)
                  << ", or leave it out: gravity then points away from the free surface.");
}

void requireDownAgainstUp(Known const& known)
{
  auto const& [dimension, surface, up, outward, down] = known;
  if (!up || !down) {
    return;
  }
  ASPERITY_REQUIRE(dot(*up, opposite(*down)) >= tilt,
                   entryOfDown() << " = " << entryText(*down, dimension) << ", but " << entryOfUp()
                                 << " = " << entryText(*up, dimension) << " is "
                                 << degreesBetween(*up, opposite(*down))
                                 << " from the opposite of it (at most 30 are allowed). Leave one "
                                    "of them out: it then follows from the other.");
}

// open: the boundaries that nothing holds, where they face one way.
Upright firstOf(Known const& known, std::optional<Vector3> const& of_open, OuterSurface const& open)
{
  Upright result;
  result.is_known = known.up || known.outward || known.down || of_open;
  if (known.up) {
    result.up = *known.up;
    result.reason = "as Output / Up says";
  } else if (known.outward) {
    result.up = snapped(*known.outward);
    result.reason = "where the free surface " + known.surface + " faces";
  } else if (known.down) {
    result.up = snapped(opposite(*known.down));
    result.reason = "against gravity";
  } else if (of_open) {
    result.up = snapped(*of_open);
    result.reason = "where " + quotedNames(open.boundaries) + " faces, which nothing holds";
  } else {
    result.reason = "by default";
  }
  result.down = known.down ? *known.down : opposite(result.up);
  return result;
}
} // namespace

Upright uprightOf(BulkSettings const& bulk, std::optional<std::vector<double>> const& given_up,
                  int dimension, OuterSurface const& surface, OuterSurface const& open)
{
  const bool has_gravity = bulk.hasGravity();
  const Known known{dimension, quotedNames(surface.boundaries),
                    dimension == 3 ? given(given_up) : std::nullopt, facing(surface, faces),
                    has_gravity ? given(bulk.gravity_direction) : std::nullopt};
  requireUpOutOfSurface(known);
  requireDownIntoSurface(known);
  requireDownAgainstUp(known);
  return firstOf(known, dimension == 3 && has_gravity ? facing(open, faces_one_way) : std::nullopt,
                 open);
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
