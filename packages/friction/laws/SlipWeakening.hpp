#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// Coulomb friction that falls with slip (Ida 1972): mu = mu_s - (mu_s - mu_d) alpha, independent of
// V > 0, with the share alpha = min(slip / d_c, 1) of the weakening that SlipWeakeningState has. At
// V = 0 the fault bears any shear stress up to mu sigma_n. Host and device.
struct SlipWeakeningLaw
{
  static constexpr char const* name = "Slip Weakening";
  static constexpr char const* state_variable = "share of slip weakening";

  double static_friction;  // mu_s
  double dynamic_friction; // mu_d

  static constexpr ParameterOf<SlipWeakeningLaw> parameters[] = {
    {&SlipWeakeningLaw::static_friction,
     {"Static Friction Coefficient", "-", no_default, 0, infinity, true, false,
      "The fault begins to slip at this coefficient mu_s.", "Check the sign."}},
    {&SlipWeakeningLaw::dynamic_friction,
     {"Dynamic Friction Coefficient", "-", no_default, 0, infinity, true, false,
      "Friction has this coefficient mu_d after slip by the slip-weakening distance.",
      "Check the sign."}},
  };

  double strengthDrop() const { return static_friction - dynamic_friction; }

  // The law at one state.
  struct Curve
  {
    double level; // mu

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

  // The alpha at which mu(V, alpha) = mu; not a finite number unless mu lies between mu_s and mu_d.
  KOKKOS_INLINE_FUNCTION double stateFor(double, double mu) const
  {
    const double alpha = (static_friction - mu) / (static_friction - dynamic_friction);
    return alpha >= 0 && alpha <= 1 ? alpha : infinity;
  }
};

// d(alpha)/dt = V / d_c until alpha = 1, where it stays. Host and device; V >= 0 in m/s.
struct SlipWeakeningState
{
  static constexpr char const* name = "Slip Weakening";
  static constexpr char const* state_variable = SlipWeakeningLaw::state_variable;
  static constexpr char const* nucleation_source =
    "slip weakening on an endless fault, Uenishi & Rice 2003";

  double distance; // d_c, m

  static constexpr ParameterOf<SlipWeakeningState> parameters[] = {
    {&SlipWeakeningState::distance,
     {"Slip-Weakening Distance", "m", no_default, 0, infinity, false, false,
      "Friction falls from its static to its dynamic coefficient, linearly over this slip d_c."}},
  };

  double slipDistance() const { return distance; }

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return alpha < 1 ? V / distance : 0;
  }

  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::larger(alpha0, detail::smaller(alpha0 + V * dt / distance, 1));
  }

  // Slip alone decides, so that no slip rate has one.
  KOKKOS_INLINE_FUNCTION double steadyState(double) const { return infinity; }
};
} // namespace asperity::friction
