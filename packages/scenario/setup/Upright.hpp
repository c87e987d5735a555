#pragma once

#include "base/Warning.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/BulkSetup.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// Where up is, as the deck and the mesh say.
struct Upright
{
  std::array<double, 3> up{0, 1, 0};    // unit vector along the axes
  std::array<double, 3> down{0, -1, 0}; // unit vector: gravity, which may be inclined to `up`
  std::string reason;                   // for the log, e.g. "to which the free surface 'top' faces"
  bool is_known = false;                // by the deck or by a surface, or +y by default
};

// A surface of the body: its boundaries, and the integral of their outward normal.
struct FreeSurface
{
  std::vector<std::string> boundaries;
  fem::NormalIntegral normal;
};

// Whether the completed list has an entry that follows from the mesh where the deck leaves it out.
bool isLeftOut(ParameterList const& list, std::string const& name);

// Up is `Up` of the deck's list `Output`, in three dimensions. Without it, it is the axis that is
// nearest to the outward normal of the free surface, or that normal itself if it is more than 40
// degrees from all axes; without a free surface that faces somewhere, the same of the vector
// against gravity, if the deck gives its direction; or else, in three dimensions where gravity
// acts, the same of the boundaries that nothing holds, those without a condition or under a
// traction (open), if they face one way. Otherwise it is +y. Throws InputError where two of free
// surface, gravity and `Up` contradict each other.
Upright uprightOf(BulkSettings const& bulk, ParameterList const& output, int dimension,
                  FreeSurface const& surface, FreeSurface const& open = {});

// A warning where gravity acts in three dimensions and nothing says which way is up.
std::optional<Warning> warnOfUp(BulkSettings const& bulk, int dimension, Upright const& upright);

// Sets `Output / Up` and `Bulk / Gravity Direction`, which points down, where the deck leaves them
// out, so that whoever reads the deck of a run finds them. Returns the deck.
ParameterList& completeDirections(ParameterList& deck, int dimension, Upright const& upright);
} // namespace asperity::scenario
