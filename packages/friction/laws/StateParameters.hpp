#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// The parameters of the ageing and the slip law, and what these say of them.
struct StateParameters
{
  static constexpr Parameter parameters[] = {
    {"L", "m", no_default, 0, infinity, false, false,
     "This is the characteristic slip distance, over which the state adapts to a new slip rate."},
    reference_slip_rate,
    {"c", "-", 0, 0, infinity, true, false,
     "A change of the normal stress shifts the state alpha by -(c / b) times the logarithm of the "
     "ratio of the new to the old normal stress (Linker and Dieterich 1992); 0 means no shift."},
  };

  // See LawProperties.hpp.
  static double slipDistance(double const* values) { return values[0]; }
  static double thetaScale(double const* values) { return values[0] / values[1]; }
  static double stressSensitivity(double const* values) { return values[2]; }

  double slip_distance;           // L, m
  double reference_rate;          // V*, m/s
  double log_reference_slip_rate; // log(V* s/m)

  // Reads column `node` of values(num_parameters, num_nodes), rows in the order of the table.
  KOKKOS_INLINE_FUNCTION static StateParameters load(ParameterView const& values, int node)
  {
    return {values(0, node), values(1, node), math::log(values(1, node))};
  }

  // log(V / V*), without the underflow of the ratio; -infinity at V = 0.
  KOKKOS_INLINE_FUNCTION double logRatio(double V) const
  {
    return math::log(V) - log_reference_slip_rate;
  }
};
} // namespace asperity::friction
