#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// Coulomb friction that falls linearly with slip (Ida 1972),
//
//   mu(alpha) = mu_s - (mu_s - mu_d) alpha,  alpha = min(slip / d_c, 1),
//
// with the static and the dynamic friction mu_s and mu_d [-] and the slip-weakening distance d_c
// [m]. The state alpha [-] is the share of the weakening so far (SlipWeakeningState). mu does not
// depend on the slip rate V > 0; at V = 0 the fault bears any shear stress up to mu sigma_n, with
// the normal stress sigma_n. Host and device.
struct SlipWeakeningLaw
{
  static constexpr char const* name = "Slip Weakening";
  static constexpr char const* state_variable = "share of slip weakening";

  double static_friction;  // mu_s
  double dynamic_friction; // mu_d

  static constexpr ParameterOf<SlipWeakeningLaw> parameters[] = {
    {&SlipWeakeningLaw::static_friction,
     {"Static Friction Coefficient", "-", no_default, Range::atLeast(0),
      "The fault begins to slip at this coefficient mu_s.", "Check the sign."}},
    {&SlipWeakeningLaw::dynamic_friction,
     {"Dynamic Friction Coefficient", "-", no_default, Range::atLeast(0),
      "Friction has this coefficient mu_d after slip by the slip-weakening distance.",
      "Check the sign."}},
  };

  double strengthDrop() const { return static_friction - dynamic_friction; }

  // The law at one state.
  struct Curve
  {
    double level; // mu

    // The friction that the fault bears at V = 0.
    KOKKOS_INLINE_FUNCTION double onset() const { return level; }
    KOKKOS_INLINE_FUNCTION double mu(double) const { return level; }
    KOKKOS_INLINE_FUNCTION double derivative(double) const { return 0; }
    KOKKOS_INLINE_FUNCTION Response response(double) const { return {level, 0, 0}; }
    KOKKOS_INLINE_FUNCTION double mean(double, double) const { return level; }
    KOKKOS_INLINE_FUNCTION bool kinkedAt(double) const { return false; }
  };

  KOKKOS_INLINE_FUNCTION Curve at(double alpha) const
  {
    const double share = detail::larger(0, detail::smaller(alpha, 1));
    return {static_friction + (dynamic_friction - static_friction) * share};
  }

  // The alpha at which mu(alpha) = mu; infinite unless mu lies between mu_s and mu_d.
  KOKKOS_INLINE_FUNCTION double stateFor(double, double mu) const
  {
    const double alpha = (static_friction - mu) / (static_friction - dynamic_friction);
    return alpha >= 0 && alpha <= 1 ? alpha : infinity;
  }
};

// The state of slip weakening: d(alpha)/dt = V / d_c while alpha < 1, and 0 from then on, with the
// slip rate V >= 0 [m/s] and the slip-weakening distance d_c [m]. Host and device.
struct SlipWeakeningState
{
  static constexpr char const* name = "Slip Weakening";
  static constexpr char const* state_variable = SlipWeakeningLaw::state_variable;
  static constexpr char const* nucleation_source =
    "slip weakening on an endless fault, Uenishi & Rice 2003";

  double distance; // d_c, m

  static constexpr ParameterOf<SlipWeakeningState> parameters[] = {
    {&SlipWeakeningState::distance,
     {"Slip-Weakening Distance", "m", no_default, Range::positive(),
      "Friction falls from its static to its dynamic coefficient, linearly over this slip d_c."}},
  };

  double slipDistance() const { return distance; }

  // d(alpha)/dt in 1/s.
  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return alpha < 1 ? V / distance : 0;
  }

  // alpha after the time dt >= 0 [s] at constant V. A value above 1 at the start stays.
  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::larger(alpha0, detail::smaller(alpha0 + V * dt / distance, 1));
  }

  // Infinite: there is no steady state, since alpha depends on slip and not on V.
  KOKKOS_INLINE_FUNCTION double steadyState(double) const { return infinity; }
};
} // namespace asperity::friction
