#pragma once

#include "fem/bulk/ReturnMapping.hpp"
#include "fem/bulk/Viscosity.hpp"
#include "registry/LawParameters.hpp"

namespace asperity::fem
{
namespace parameter
{
inline constexpr Parameter hardening = {
  "Hardening", "Pa", 0, Range::atLeast(0),
  "The yield stress grows by this value for each unit of inelastic shear strain."};
inline constexpr Parameter residual_share = {
  "Residual Share", "-", 1, Range::openClosed(0, 1),
  "The cohesion (of Von Mises the shear strength) falls to this share of itself with inelastic "
  "shear; 1: it stays."};
inline constexpr Parameter softening_shear = {
  "Softening Shear", "-", 0.01, Range::positive(),
  "The cohesion falls to that share in proportion to the inelastic shear strain, "
  "over this one."};
inline constexpr Parameter yield_relaxation = {
  "Yield Relaxation Time", "s", 0, Range::atLeast(0),
  "Stress above the yield stress falls to 1/e within this time (Duvaut and Lions); 0: at once."};

} // namespace parameter

// What laws with a yield stress have in common; they may also be viscous.
struct Yield : Viscosity
{
  double hardening;       // H [Pa]
  double relaxation_time; // [s]
  double residual_share;  // [-]
  double softening_shear; // [-]

  // The share of a cohesion that the inelastic shear of the steps before has left. It stays during
  // a step: if it fell within one, so would t1(t), and J would not be convex.
  KOKKOS_INLINE_FUNCTION double softened(Trial const& trial) const
  {
    const double softening_fraction =
      trial.shear < softening_shear ? trial.shear / softening_shear : 1;
    return 1 - (1 - residual_share) * softening_fraction;
  }

  // The share of a stress above the yield stress that is left at the end of the step.
  KOKKOS_INLINE_FUNCTION double leftOver(Trial const& trial) const
  {
    return relaxation_time > 0 ? math::exp(-trial.step / relaxation_time) : 0;
  }

  // t1 where the yield stress is `strength` [Pa] without inelastic shear and has the slope H, and
  // what lies above it relaxes:
  //   t_y = strength + H gamma1,   t1 = t_y + (t - t_y) exp(-step / relaxation time)
  // With hardening, gamma1 is that of the return without relaxation.
  KOKKOS_INLINE_FUNCTION double yielded(double strength, Trial const& trial) const
  {
    const double G = trial.shear_modulus, H = hardening;
    const double at_start = (strength > 0 ? strength : 0) + H * trial.shear;
    if (trial.shear_stress <= at_start) {
      return trial.shear_stress;
    }
    const double over = trial.shear_stress - at_start;
    const double without = at_start + H / (G + H) * over;
    return without + (trial.shear_stress - without) * leftOver(trial);
  }
};
} // namespace asperity::fem
