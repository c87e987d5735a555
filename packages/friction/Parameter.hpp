#pragma once

#include "portability/Parameter.hpp"

namespace asperity::friction
{
using asperity::infinity;
using asperity::no_default;
using asperity::Parameter;

// The slip rate that the direct effect and the evolution of the state refer to.
inline constexpr Parameter reference_slip_rate{
  "Reference Slip Rate",
  "m/s",
  1e-6,
  0,
  infinity,
  false,
  false,
  "At this slip rate V* friction in steady sliding has the reference coefficient."};
} // namespace asperity::friction
