#pragma once

#include "friction/detail/Math.hpp"

namespace asperity::friction::detail
{
// Slip rates below this, in m/s, are replaced by 0.
inline constexpr double smallest_slip_rate = 1e-300;

struct RateSolution
{
  double V; // m/s
  bool converged;
};

// The slip rate V at which drag V + strength mu(V) = load; drag > 0 in N s/m, strength >= 0 and
// load > 0 in N. The left-hand side grows with V, hence 0 < V <= load / drag. It starts from 0, but
// from strength mu(0) under a law with onset(); a load up to that gives V = 0.
//
// Newton's method in the variable V^p, which is exact where the curve is logarithmic in V (p = 0)
// and where it is linear (p = 1): p is chosen such that the second derivative vanishes, so the
// order is three. The solution stays in a bracket: an iterate that leaves it is replaced by the
// geometric mean of its ends.
template <class Curve>
class RateSolve
{
public:
  KOKKOS_INLINE_FUNCTION RateSolve(Curve const& curve, double drag, double strength, double load)
      : curve_(curve)
      , drag_(drag)
      , strength_(strength)
      , load_(load)
      , high_(load / drag)
  {
  }

  // `guess` is used where it is positive.
  KOKKOS_INLINE_FUNCTION RateSolution solve(double guess)
  {
    if (!(high_ > low_)) {
      return {0, high_ <= low_};
    }
    double V = guess > 0 ? larger(low_, smaller(guess, high_)) : high_;
    for (int evaluation = 0; evaluation < largest_count; ++evaluation) {
      const auto response = curve_.response(V);
      const double forces = drag_ * V + strength_ * response.mu;
      const double residual = forces - load_;
      if (!isFinite(residual)) {
        return {0, false};
      }
      if (residual >= 0 && V == smallest_slip_rate) {
        return {0, true};
      }
      tighten(V, residual);
      const double slope = drag_ * V + strength_ * response.first;
      const double step = residual / slope; // relative to V
      const double next = stepped(V, step, (drag_ * V + strength_ * response.second) / slope);
      // The error of `next` is of the order of step^3, or the bracket consists of rounding alone.
      if (math::fabs(step) < 2e-6 || high_ <= low_ * (1 + 2 * epsilon)) {
        return {next, true};
      }
      if (math::fabs(residual) <= 2 * epsilon * (forces + load_)) {
        return {V, true};
      }
      V = evaluation < trusted_count ? kept(next) : middle();
    }
    return {0, false};
  }

private:
  static constexpr int trusted_count = 40;
  static constexpr int largest_count =
    120; // bisection needs 11 for the decade and 52 for the digits

  // The slip rate W after a step of Newton's method in V^p: W^p = V^p (1 - p step), which is
  // W = V exp(-step) for p = 0.
  KOKKOS_INLINE_FUNCTION static double stepped(double V, double step, double p)
  {
    if (math::fabs(step) < 0.2) {
      return V - V * step / (1 + 0.5 * (1 - p) * step); // the same to third order
    }
    if (math::fabs(p) < 1e-8) {
      return V * math::exp(-step);
    }
    return p * step < 1 ? V * math::exp(math::log1p(-p * step) / p) : 0;
  }

  KOKKOS_INLINE_FUNCTION void tighten(double V, double residual)
  {
    if (residual > 0) {
      high_ = V;
      high_known_ = true;
    } else {
      low_ = V;
      low_known_ = true;
    }
  }

  // An end of the bracket that was not evaluated yet may be the solution itself.
  KOKKOS_INLINE_FUNCTION double kept(double next) const
  {
    if (next > low_ && next < high_) {
      return next;
    }
    if (next <= low_ && !low_known_) {
      return low_;
    }
    return next >= high_ && !high_known_ ? high_ : middle();
  }

  KOKKOS_INLINE_FUNCTION double middle() const { return math::sqrt(low_) * math::sqrt(high_); }

  Curve curve_;
  double drag_;
  double strength_;
  double load_;
  double low_ = smallest_slip_rate;
  double high_;
  bool low_known_ = false;
  bool high_known_ = false;
};
} // namespace asperity::friction::detail
