#pragma once

#include "unit/io/BlockMesh.hpp"
#include "unit/io/Stage.hpp"

namespace asperity::test
{
// The fields of a body x > 0 and of the vertical fault x = 0 beside it, from y = 0 down to y = -4;
// strike is along z. It is the base of the block mesh, turned about the z axis.
struct VerticalFault : Stage
{
  explicit VerticalFault(bool periodic = false)
      : Stage(blockMesh(periodic, [](Point<3> const& x) {
        return Point<3>{x[1], 0 - x[0], x[2]};
      }))
  {
    add("fault", "slip", 3, [](double const* x, int c) { return c == 0 ? 0 : c * (x[2] - x[1]); });
    add("fault", "slip_rate", 1, [](double const*, int) { return 0.5; });
    add("fault", "slip_velocity", 3, [](double const*, int c) { return c == 0 ? 0 : 0.3 * c; });
    add("fault", "traction", 3, [](double const* x, int c) { return 1e6 * (c + x[2]); });
    add("fault", "normal_stress", 1, [](double const*, int) { return 2.5e7; });
    add("fault", "theta", 1, [](double const*, int) { return 1e8; });
    add("volume", "displacement", 3, [](double const* x, int c) { return x[c]; });
    add("volume", "velocity", 3, [](double const*, int c) { return c + 1; });
  }
};
} // namespace asperity::test
