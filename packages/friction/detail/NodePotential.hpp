#pragma once

#include "friction/detail/RateSolve.hpp"

namespace asperity::friction::detail
{
// psi(w) = weight [ sigma_n mubar(c |w|) / c + cohesion |w| ] at one node and one state.
template <class Curve>
struct NodePotential
{
  double weight;   // m^(d-1)
  double sigma_n;  // Pa
  double cohesion; // Pa
  double factor;   // c
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

  // d^2 psi / d|w|^2 in N s/m.
  KOKKOS_INLINE_FUNCTION double secondDerivative(double s) const
  {
    const double strength = weight * sigma_n;
    return strength == 0 ? 0 : strength * factor * curve.derivative(factor * s);
  }

  // Whether psi has no second derivative at vectors of length s.
  KOKKOS_INLINE_FUNCTION bool kinkedAt(double s) const
  {
    return (s == 0 && weight * cohesion > 0) ||
           (weight * sigma_n > 0 && curve.kinkedAt(factor * s));
  }

  // The length of argmin_w curvature/2 |w|^2 - <r, w> + psi(w) for |r| = load.
  KOKKOS_INLINE_FUNCTION RateSolution minimise(double curvature, double load, double guess) const
  {
    const double excess = load - weight * cohesion;
    if (!(curvature > 0) || !isFinite(excess)) {
      return {0, false};
    }
    if (excess <= 0) {
      return {0, true};
    }
    RateSolve<Curve> solve(curve, curvature / factor, weight * sigma_n, excess);
    const RateSolution solution = solve.solve(factor * guess);
    return {solution.V / factor, solution.converged};
  }
};
} // namespace asperity::friction::detail
