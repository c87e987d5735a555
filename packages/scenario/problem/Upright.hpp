#pragma once

#include "base/Warning.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "scenario/setup/Vector3.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// Where up is, as the deck and the mesh say.
struct Upright
{
  Vector3 up{0, 1, 0};    // unit vector along the axes
  Vector3 down{0, -1, 0}; // unit vector: gravity, which may be inclined to `up`
  std::string reason;     // for the log: "where the free surface 'top' faces"
  bool is_known = false;  // by the deck or by a surface, or +y by default
};

// A part of the outer surface of the body: its boundaries, and the integral of their outward
// normal.
struct OuterSurface
{
  std::vector<std::string> boundaries;
  fem::NormalIntegral normal;
};

// Up is the first of these vectors that exists:
//   1. given_up, the deck's `Output / Up` (givenUp), in three dimensions;
//   2. the outward normal of the free surface, if that surface faces one way;
//   3. the vector against the deck's `Bulk / Gravity Direction`, if gravity acts;
//   4. in three dimensions with gravity, the outward normal of `open`, the boundaries without a
//      condition or under a traction, if they face one way;
//   5. +y.
// Vectors 2 to 4 are replaced by the axis nearest to them, unless it is more than 40 degrees away.
// Throws InputError where two of the first three contradict each other.
Upright uprightOf(BulkSettings const& bulk, std::optional<std::vector<double>> const& given_up,
                  int dimension, OuterSurface const& surface, OuterSurface const& open = {});

// A warning where gravity acts in three dimensions and nothing says which way is up.
std::optional<Warning> warnOfUp(BulkSettings const& bulk, int dimension, Upright const& upright);
} // namespace asperity::scenario
