#pragma once

#include "friction/detail/Math.hpp"

namespace asperity::friction::detail
{
struct StateSolution
{
  double alpha;
  bool converged;
};

// One step of backward Euler, g(alpha) = alpha - alpha0 - dt rate(V, alpha) = 0, for a law that has
//   double rate(double V, double alpha)            d(alpha)/dt in 1/s, not increasing in alpha
//   double rateDerivative(double V, double alpha)  its derivative by alpha, <= 0, in 1/s
// Since g' >= 1 there is exactly one zero for every dt. Steps from alpha0 that double in length
// bracket it; then Newton's method finds it, with bisection where Newton leaves the bracket or is
// slow.
template <class Law>
class BackwardEuler
{
public:
  KOKKOS_INLINE_FUNCTION BackwardEuler(Law const& law, double V, double dt, double alpha0)
      : law_(law)
      , V_(V)
      , dt_(dt)
      , alpha0_(alpha0)
      , low_(alpha0)
      , high_(alpha0)
  {
  }

  KOKKOS_INLINE_FUNCTION StateSolution solve()
  {
    double alpha = alpha0_;
    if (!bracket(alpha)) {
      return {alpha0_, false};
    }
    double previous = high_ - low_;
    for (int evaluation = 0; evaluation < largest_count; ++evaluation) {
      const double g = defect(alpha);
      (g > 0 ? high_ : low_) = alpha;
      const double tolerance = 2 * epsilon * (1 + math::fabs(alpha));
      if (g == 0 || high_ - low_ <= tolerance) {
        return {alpha, true};
      }
      double step = -g / (1 - dt_ * law_.rateDerivative(V_, alpha));
      const bool inside = alpha + step >= low_ && alpha + step <= high_;
      if (!inside || 2 * math::fabs(step) > previous) {
        step = 0.5 * (low_ + high_) - alpha;
      }
      previous = math::fabs(step);
      alpha += step;
      if (previous <= tolerance) {
        return {alpha, true};
      }
    }
    return {alpha0_, false};
  }

private:
  static constexpr int largest_count = 200;
  static constexpr double longest_stride = 1e12;

  KOKKOS_INLINE_FUNCTION double defect(double alpha) const
  {
    return alpha - alpha0_ - dt_ * law_.rate(V_, alpha);
  }

  // The end that was found last is the first guess.
  KOKKOS_INLINE_FUNCTION bool bracket(double& end)
  {
    const double direction = defect(alpha0_) > 0 ? -1 : 1;
    double& front = direction > 0 ? high_ : low_;
    double& rear = direction > 0 ? low_ : high_;
    for (double stride = 1; stride < longest_stride; stride *= 2) {
      front = alpha0_ + direction * stride;
      if (direction * defect(front) >= 0) {
        end = front;
        return true;
      }
      rear = front;
    }
    return false;
  }

  Law law_;
  double V_;
  double dt_;
  double alpha0_;
  double low_;
  double high_;
};
} // namespace asperity::friction::detail
