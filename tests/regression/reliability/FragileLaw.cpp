// A state law that loses a number: the state grows with time, d(alpha)/dt = 1/s, and beyond a limit
// it is not a number any more. Where the limit is out of reach nothing happens.
#include "friction/Registration.hpp"

namespace
{
using namespace asperity::friction;

struct FragileLaw
{
  static constexpr char const* name = "Fragile";

  double limit;

  static constexpr ParameterOf<FragileLaw> parameters[] = {
    {&FragileLaw::limit,
     {"Limit", "-", no_default, Range::positive(), "State beyond which there is none."}}};

  KOKKOS_INLINE_FUNCTION double rate(double, double) const { return 1; }
  KOKKOS_INLINE_FUNCTION double flow(double, double dt, double alpha0) const
  {
    const double alpha = alpha0 + dt;
    return alpha < limit ? alpha : alpha * (infinity - infinity);
  }
  KOKKOS_INLINE_FUNCTION double steadyState(double) const { return 0; }
};
} // namespace

ASPERITY_REGISTER_STATE_LAW(FragileLaw)
