#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

// The friction laws once more, as they stand in the literature, in long double: its exponents reach
// V_alpha, and what it rounds is 2000 times less. Slow, and written without a look at the kernels.
namespace asperity::friction::test
{
using Real = long double;

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline constexpr double smallest = std::numeric_limits<double>::denorm_min();

struct ReferenceLaw
{
  std::string name; // "Regularised" or "Truncated"
  double a;
  double b;
  double reference_slip_rate;
  double reference_friction;

  Real vAlpha(double alpha) const
  {
    return reference_slip_rate * std::exp(-(reference_friction + Real(b) * alpha) / a);
  }

  Real mu(Real V, double alpha) const
  {
    if (name == "Regularised") {
      return a * std::asinh(V / (2 * vAlpha(alpha)));
    }
    return V > vAlpha(alpha) ? a * std::log(V / vAlpha(alpha)) : Real(0);
  }

  // dmu/dV
  Real derivative(Real V, double alpha) const
  {
    if (name == "Regularised") {
      return a / std::hypot(V, 2 * vAlpha(alpha));
    }
    return V > vAlpha(alpha) ? a / V : Real(0);
  }

  // What mu in double may be off: the rounding of log V and of the exponent of V_alpha.
  Real muTolerance(Real V, double alpha) const
  {
    const Real exponent = std::abs((reference_friction + std::abs(b * alpha)) / a);
    const Real digits = exponent + std::abs(std::log(Real(reference_slip_rate))) +
                        (V > 0 ? std::abs(std::log(V)) : Real(0));
    return 2 * epsilon * (a * digits + mu(V, alpha)) + smallest;
  }

  // The average of mu between V and V + h, by tanh-sinh quadrature on either side of the kink.
  Real mean(Real V, Real h, double alpha) const
  {
    const Real kink = (vAlpha(alpha) - V) / h;
    if (name == "Truncated" && kink > 0 && kink < 1) {
      return kink * meanOfPiece(V, kink * h, alpha) +
             (1 - kink) * meanOfPiece(V + kink * h, (1 - kink) * h, alpha);
    }
    return meanOfPiece(V, h, alpha);
  }

private:
  Real meanOfPiece(Real V, Real h, double alpha) const
  {
    const Real half_pi = std::acos(Real(-1)) / 2;
    const Real step = Real(1) / 32;
    Real sum = 0;
    for (int k = -140; k <= 140; ++k) {
      const Real t = k * step;
      const Real fraction = 1 / (1 + std::exp(-2 * half_pi * std::sinh(t)));
      const Real cosh = std::cosh(half_pi * std::sinh(t));
      sum += half_pi * std::cosh(t) / (2 * cosh * cosh) * mu(V + h * fraction, alpha);
    }
    return sum * step;
  }
};

// psi'(s), c the slip factor.
struct ReferenceNode
{
  ReferenceLaw law;
  double weight;
  double sigma_n;
  double cohesion;
  double factor;
  double alpha;

  Real force(Real s) const { return weight * (sigma_n * law.mu(factor * s, alpha) + cohesion); }

  Real forceTolerance(Real s) const
  {
    return weight * sigma_n * law.muTolerance(factor * s, alpha) + 4 * epsilon * force(s);
  }
};

using Vector2 = std::array<Real, 2>;

inline Real norm(Vector2 const& w) { return std::hypot(w[0], w[1]); }
} // namespace asperity::friction::test
