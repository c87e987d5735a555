#pragma once

#include "portability/Renamed.hpp"

namespace asperity::dynamics
{
// (1 - exp(-x)) / x for x >= 0: the mean over a step of what decays by exp(-x) in it.
KOKKOS_INLINE_FUNCTION double meanDecay(double x) { return x > 0 ? -math::expm1(-x) / x : 1; }
} // namespace asperity::dynamics
