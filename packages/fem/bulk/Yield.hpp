#pragma once

#include "fem/bulk/ReturnMapping.hpp"
#include "portability/Parameter.hpp"

// What laws with a yield stress have in common.
namespace asperity::fem
{
inline constexpr Parameter hardening = {
  "Hardening", "Pa",
  0,           0,
  infinity,    true,
  false,       "The yield stress grows by this value for each unit of inelastic shear strain."};
inline constexpr Parameter yield_relaxation = {
  "Yield Relaxation Time",
  "s",
  0,
  0,
  infinity,
  true,
  false,
  "Stress above the yield stress falls to 1/e within this time (Duvaut and Lions); 0: at once."};

// t1 where the yield stress is `strength` [Pa] without inelastic shear and has a slope H [Pa], and
// what lies above it relaxes with the time [s]:
//   t_y = strength + H gamma1,   t1 = t_y + (t - t_y) exp(-step / time)
// With hardening, gamma1 is that of the return without relaxation.
KOKKOS_INLINE_FUNCTION double yielded(double strength, double H, double time, Trial const& trial)
{
  const double G = trial.shear_modulus;
  const double at_start = (strength > 0 ? strength : 0) + H * trial.shear;
  if (trial.shear_stress <= at_start) {
    return trial.shear_stress;
  }
  const double over = trial.shear_stress - at_start;
  const double without = at_start + H / (G + H) * over;
  return time > 0 ? without + (trial.shear_stress - without) * math::exp(-trial.step / time)
                  : without;
}
} // namespace asperity::fem
