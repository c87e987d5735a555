#pragma once

#include "friction/detail/PartlyPrescribed.hpp"
#include "friction/detail/RateSolve.hpp"

#include <type_traits>
#include <utility>

namespace asperity::friction::detail
{
template <class Curve, class = void>
struct HasTerms : std::false_type
{
};
template <class Curve>
struct HasTerms<Curve, std::void_t<decltype(std::declval<Curve const&>().terms(1.))>>
    : std::true_type
{
};

// The sum of the magnitudes of the terms that mu(V) is computed from, V > 0; mu itself for a law
// without `terms`.
template <class Curve>
KOKKOS_INLINE_FUNCTION double termsOf(Curve const& curve, double V)
{
  if constexpr (HasTerms<Curve>::value) {
    return curve.terms(V);
  } else {
    return curve.mu(V);
  }
}

template <class Curve, class = void>
struct HasOnset : std::false_type
{
};
template <class Curve>
struct HasOnset<Curve, std::void_t<decltype(std::declval<Curve const&>().onset())>> : std::true_type
{
};

// psi(w) = weight [ sigma_n mubar(chi |w|) / chi + cohesion |w| ] at one node and one state.
template <class Curve>
struct NodePotential
{
  double weight;   // m^(d-1)
  double sigma_n;  // Pa
  double cohesion; // Pa
  double factor;   // chi
  Curve curve;

  // d psi / d|w| in N, at |w| = s in m/s.
  KOKKOS_INLINE_FUNCTION double derivative(double s) const
  {
    return weight * (sigma_n * curve.mu(factor * s) + cohesion);
  }

  // The average of d psi / d|w| between s and s + h, in N.
  KOKKOS_INLINE_FUNCTION double meanDerivative(double s, double h) const
  {
    return weight * (sigma_n * curve.mean(factor * s, factor * h) + cohesion);
  }

  // The sum of the magnitudes of the terms of the derivative at |w| = s, in N: the scale of its
  // rounding. With s the faster end it serves for meanDerivative, too: where |log V| is larger at
  // the slower end, the magnitude of shift is of the same size.
  KOKKOS_INLINE_FUNCTION double termsOfDerivative(double s) const
  {
    const double V = factor * s;
    return weight * (sigma_n * (V > 0 ? termsOf(curve, V) : 0) + cohesion);
  }

  // d^2 psi / d|w|^2 in N s/m.
  KOKKOS_INLINE_FUNCTION double secondDerivative(double s) const
  {
    const double strength = weight * sigma_n;
    return strength == 0 ? 0 : strength * factor * curve.derivative(factor * s);
  }

  // The largest force [N] that a node at rest bears: d psi / d|w| just above |w| = 0.
  KOKKOS_INLINE_FUNCTION double forceAtRest() const
  {
    if constexpr (HasOnset<Curve>::value) {
      return weight * (sigma_n * curve.onset() + cohesion);
    } else {
      return weight * cohesion;
    }
  }

  // Whether psi has no second derivative at vectors of length s.
  KOKKOS_INLINE_FUNCTION bool kinkedAt(double s) const
  {
    return (s == 0 && forceAtRest() > 0) || (weight * sigma_n > 0 && curve.kinkedAt(factor * s));
  }

  // The length of argmin_w curvature/2 |w|^2 - <r, w> + psi(w) for |r| = load.
  KOKKOS_INLINE_FUNCTION RateSolution minimise(double curvature, double load, double guess) const
  {
    const double excess = load - weight * cohesion;
    if (!(curvature > 0) || !isFinite(excess)) {
      return {0, false};
    }
    if (load <= forceAtRest()) {
      return {0, true};
    }
    RateSolve<Curve> solve(curve, curvature / factor, weight * sigma_n, excess);
    const RateSolution solution = solve.solve(factor * guess);
    return {solution.V / factor, solution.converged};
  }

  // The length of argmin_w curvature/2 |w|^2 - <r, w> + psi(w + p) for |r| = load, where w is at
  // right angles to p, the prescribed rate, and |p| > 0 is given first. As psi is convex, so is its
  // restriction, and it is smooth at w = 0.
  KOKKOS_INLINE_FUNCTION RateSolution minimiseWithPrescribed(double prescribed_rate,
                                                             double curvature, double load,
                                                             double guess) const
  {
    if (!(curvature > 0) || !isFinite(load)) {
      return {0, false};
    }
    RateSolve<PartlyPrescribed<Curve>> solve({curve, sigma_n, cohesion, factor * prescribed_rate},
                                             curvature / factor, weight, load);
    const RateSolution solution = solve.solve(factor * guess);
    return {solution.V / factor, solution.converged};
  }
};
} // namespace asperity::friction::detail
