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
inline constexpr Parameter residual_share = {
  "Residual Share",
  "-",
  1,
  0,
  1,
  false,
  true,
  "The cohesion (of Von Mises the shear strength) falls to this share of itself with inelastic "
  "shear; 1: it stays."};
inline constexpr Parameter softening_shear = {
  "Softening Shear",
  "-",
  0.01,
  0,
  infinity,
  false,
  false,
  "The cohesion falls to that share in proportion to the inelastic shear strain, "
  "over this one."};
inline constexpr Parameter yield_relaxation = {
  "Yield Relaxation Time",
  "s",
  0,
  0,
  infinity,
  true,
  false,
  "Stress above the yield stress falls to 1/e within this time (Duvaut and Lions); 0: at once."};

// The share of a cohesion that the inelastic shear of the steps before has left. It stays during a
// step: if it fell within one, so would t1(t), and J would not be convex.
KOKKOS_INLINE_FUNCTION double softened(double residual, double softening, Trial const& trial)
{
  const double softening_fraction = trial.shear < softening ? trial.shear / softening : 1;
  return 1 - (1 - residual) * softening_fraction;
}

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
