#include "fem/bulk/BulkLaw.hpp"

namespace asperity::fem
{
namespace
{
// Dislocation creep: in addition to the elastic strain the rock has an inelastic one of the rate
//   e' = A t^(n - 1) s,   t = sqrt(s : s / 2),
// in steps of backward Euler: t1 + 2 G A tau t1^n = t. Of all functions of the trial t this one
// alone keeps the stress (rate / A)^(1 / n) of steady flow, however long the steps; all are first
// order at best. n = 1 is Maxwell's law with the viscosity 1 / (2 A).
struct PowerLaw
{
  static constexpr char const* name = "Power Law";

  double prefactor; // A [1/(Pa^n s)]
  double exponent;  // n [-]

  static constexpr ParameterOf<PowerLaw> parameters[] = {
    {&PowerLaw::prefactor,
     {"Prefactor", "1/(Pa^n s)", no_default, Range::atLeast(0),
      "This is A in the rate A t^(n - 1) s of inelastic strain, with the deviatoric stress s and "
      "t = sqrt(s : s / 2). If rate = B stress^n was measured under axial load, A = 3^((n + 1) / "
      "2) B / 2. Where it is 0, the rock is elastic."}},
    {&PowerLaw::exponent,
     {"Stress Exponent", "-", no_default, Range::atLeast(1),
      "This is n in that rate. With 1 the viscosity is 1 / (2 A), with more it falls with "
      "stress."}}};

  KOKKOS_FUNCTION double shearStress(Trial const& trial) const
  {
    const double A = prefactor, n = exponent, t = trial.shear_stress;
    const bool at_start = !(trial.step < infinity); // the rock bears any stress, and then flows
    if (at_start || A == 0 || t == 0) {
      return t;
    }
    const double log_flow = math::log(2 * trial.shear_modulus) + math::log(A) +
                            math::log(trial.step) + (n - 1) * math::log(t);
    return t * math::exp(logOfShare(log_flow, n));
  }

  // log x of the x that has x + exp(f) x^n = 1. The logarithm of the left side is convex in log x,
  // with slopes from 1 to n: Newton's iterates from above fall to the root, and log 2 is the
  // furthest that they have to go. Sums of logarithms do not overflow.
  KOKKOS_FUNCTION static double logOfShare(double f, double n)
  {
    double z = f > 0 ? -f / n : 0; // where the larger term is 1
    const double lowest = z - 0.7;
    for (int iteration = 0; iteration < 100; ++iteration) {
      const double ratio = f + (n - 1) * z; // log of the second term over the first
      const double smaller = math::exp(ratio > 0 ? -ratio : ratio);
      const double logarithm = (ratio > 0 ? z + ratio : z) + math::log1p(smaller);
      const double of_second = (ratio > 0 ? 1 : smaller) / (1 + smaller);
      const double next = z - logarithm / (1 + (n - 1) * of_second);
      if (!(next < z && next > lowest)) { // rounding
        break;
      }
      z = next;
    }
    return z;
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::PowerLaw)
