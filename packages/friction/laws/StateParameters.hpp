#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// The parameters that the ageing and the slip law share, and the properties that follow from them.
struct StateParameters
{
  double slip_distance;      // L, m
  double reference_rate;     // V*, m/s
  double stress_sensitivity; // c, dimensionless (Linker & Dieterich 1992)
  double log_reference_rate; // ln(V* s/m)

  static constexpr ParameterOf<StateParameters> parameters[] = {
    {&StateParameters::slip_distance, parameter::slip_distance},
    {&StateParameters::reference_rate, parameter::reference_slip_rate},
    {&StateParameters::stress_sensitivity,
     {"c", "-", 0, Range::atLeast(0),
      "A change of the normal stress shifts the state alpha by -(c / b) times the logarithm of the "
      "ratio of the new to the old normal stress (Linker and Dieterich 1992); 0 means no shift."}},
  };

  KOKKOS_INLINE_FUNCTION void prepare() { log_reference_rate = math::log(reference_rate); }

  // See LawProperties.hpp.
  double slipDistance() const { return slip_distance; }
  double thetaScale() const { return slip_distance / reference_rate; }
  double stressSensitivity() const { return stress_sensitivity; }

  // ln(V / V*), without the underflow of the ratio; -infinity at V = 0.
  KOKKOS_INLINE_FUNCTION double logRatio(double V) const
  {
    return math::log(V) - log_reference_rate;
  }
};
} // namespace asperity::friction
