// A friction law of your own: a film of a Newtonian fluid, whose coefficient of friction grows
// with the slip rate, mu = V / V1. packages/friction/README.md says what a law has to have.
#include "friction/Registration.hpp"

namespace
{
using namespace asperity::friction;

struct ViscousLaw
{
  static constexpr char const* name = "Viscous";

  double rate; // V1, m/s

  static constexpr ParameterOf<ViscousLaw> parameters[] = {
    {&ViscousLaw::rate,
     {"Viscous Slip Rate", "m/s", no_default, Range::positive(),
      "Slip rate V1 at which the coefficient of friction is 1.", "Check the sign."}}};

  // The law at a given state; this law does not depend on the state.
  struct Curve
  {
    double rate;

    KOKKOS_INLINE_FUNCTION double mu(double V) const { return V / rate; }
    KOKKOS_INLINE_FUNCTION double derivative(double) const { return 1 / rate; }
    KOKKOS_INLINE_FUNCTION Response response(double V) const
    {
      return {V / rate, V / rate, V / rate};
    }
    KOKKOS_INLINE_FUNCTION double mean(double V, double h) const { return (V + h / 2) / rate; }
    KOKKOS_INLINE_FUNCTION bool kinkedAt(double) const { return false; }
  };

  KOKKOS_INLINE_FUNCTION Curve at(double) const { return {rate}; }
  KOKKOS_INLINE_FUNCTION double stateFor(double, double) const { return infinity; } // there is none
};
} // namespace

ASPERITY_REGISTER_FRICTION_LAW(ViscousLaw)
