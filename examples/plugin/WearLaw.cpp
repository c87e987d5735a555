// A state law of your own: slip wears the state down, d(alpha)/dt = -V alpha / D, so that alpha
// falls to alpha exp(-slip / D). It does not declare theta, so that there is no output `theta`.
#include "friction/Registration.hpp"

namespace
{
using namespace asperity::friction;

struct WearLaw
{
  static constexpr char const* name = "Wear";

  double distance; // D, m

  static constexpr ParameterOf<WearLaw> parameters[] = {
    {&WearLaw::distance,
     {"Wear Distance", "m", no_default, Range::positive(),
      "Slip D that reduces the state by a factor e."}}};

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const { return -V * alpha / distance; }
  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return alpha0 * math::exp(-V * dt / distance);
  }
  KOKKOS_INLINE_FUNCTION double steadyState(double) const { return 0; }
};
} // namespace

ASPERITY_REGISTER_STATE_LAW(WearLaw)
