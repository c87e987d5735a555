#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// The parameters of mu = mu* + a log(V / V*) + b alpha = a log(V / V_alpha), which the regularised
// and the truncated law keep from becoming negative (Pipping 2014, §1.2).
//
// V_alpha = V* exp(-(mu* + b alpha) / a) underflows for common parameters and never appears: all
// is said in x(V) = log(V / V_alpha) = log V + shift(alpha).
struct DirectEffect
{
  static constexpr Parameter table[] = {
    {"a", "-", no_default, 0, infinity, false, false,
     "This is the weight of the direct effect: mu grows by this value when the slip rate grows by "
     "a factor e.",
     "Check the sign; typical values are 0.005 to 0.03."},
    {"b", "-", no_default, 0, infinity, true, false,
     "This is the weight of the state: mu grows by this value when the state theta grows by a "
     "factor e."},
    reference_slip_rate,
    {"Reference Friction Coefficient", "-", 0.6, 0, infinity, true, false,
     "Friction has this coefficient mu* in steady sliding at the reference slip rate."},
  };

  double a;
  double b;
  double log_reference_slip_rate; // log(V* s/m)
  double reference_friction;      // mu*

  // Reads column `node` of parameters(num_parameters, num_nodes), rows in the order of the table.
  KOKKOS_INLINE_FUNCTION static DirectEffect load(ParameterView const& parameters, int node)
  {
    return {parameters(0, node), parameters(1, node), math::log(parameters(2, node)),
            parameters(3, node)};
  }

  static Sensitivity sensitivity(double const* values) { return {values[0], values[1]}; }

  // -log(V_alpha s/m)
  KOKKOS_INLINE_FUNCTION double shift(double alpha) const
  {
    return (reference_friction + b * alpha) / a - log_reference_slip_rate;
  }

  // The alpha at which log(V / V_alpha) = x; not a finite number if b = 0.
  KOKKOS_INLINE_FUNCTION double stateAt(double V, double x) const
  {
    return (a * (x - (math::log(V) - log_reference_slip_rate)) - reference_friction) / b;
  }
};
} // namespace asperity::friction
