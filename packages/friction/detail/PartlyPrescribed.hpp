#pragma once

#include "friction/Length.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction::detail
{
// Friction against the free part V of a slip rate whose other part p, at right angles to it, is
// prescribed: of the shear traction sigma_n mu(|V|) + cohesion, which acts against the whole slip
// rate S = sqrt(V^2 + p^2), the free part bears the share r = V / S. As the response of a curve, in
// Pa, with its derivatives with respect to log V, from d(log S) = r^2 d(log V) and
// dr = r (1 - r^2) d(log V).
template <class Curve>
struct PartlyPrescribed
{
  Curve curve;
  double sigma_n;         // Pa
  double cohesion;        // Pa
  double prescribed_rate; // p > 0, m/s

  KOKKOS_INLINE_FUNCTION Response response(double V) const
  {
    const double parts[2] = {V, prescribed_rate};
    const double S = length(parts);
    const auto response = curve.response(S);
    const double tau = sigma_n * response.mu + cohesion;
    const double r = V / S, rr = r * r,
                 across = (prescribed_rate / S) * (prescribed_rate / S); // 1 - r^2
    const double first = sigma_n * response.first, second = sigma_n * response.second;
    return {r * tau, r * (rr * first + across * tau),
            r * (rr * rr * second + 4 * rr * across * first + across * (1 - 3 * rr) * tau)};
  }
};
} // namespace asperity::friction::detail
