#pragma once

#include "unit/io/Stage.hpp"

namespace asperity::test
{
// The fields of a strip and of its base, the fault. They are linear in place, so that interpolation
// is exact. Slip rates are zero where x = 0.
struct LinearFault : Stage
{
  explicit LinearFault(int displacement_components = 2, Mesh<2> const& mesh = stripMesh(6))
      : Stage(mesh)
  {
    add("fault", "slip", 1, [this](double const* x, int) { return time * x[0]; });
    add("fault", "slip_rate", 1, [](double const* x, int) { return x[0]; });
    add("fault", "traction", 1, [this](double const* x, int) { return 1e6 * (x[0] - time); });
    add("fault", "normal_stress", 1, [](double const* x, int) { return 5e7 + 1e6 * x[0]; });
    add("fault", "theta", 1, [](double const*, int) { return 1e8; });
    add("volume", "displacement", displacement_components,
        [this](double const* x, int c) { return (c + 1) * (x[0] + 2 * x[1]) + time; });
    add("volume", "velocity", displacement_components,
        [](double const* x, int c) { return (c + 1) * x[1]; });
  }
};
} // namespace asperity::test
