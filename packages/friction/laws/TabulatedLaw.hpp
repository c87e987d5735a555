#pragma once

#include "friction/Table.hpp"
#include "friction/laws/SteadyFriction.hpp"

namespace asperity::friction
{
// The state law (SteadyFriction) whose steady friction f_ss > 0 [-] comes from a table: a function
// of log10(V s/m), where V >= 0 is the slip rate [m/s]. At a given state friction increases with V
// whatever the table, since the friction law is the regularised one. Host and device.
struct TabulatedLaw : SteadyFriction<TabulatedLaw>
{
  static constexpr char const* name = "Tabulated";
  static constexpr ParameterOf<SteadyFriction> parameters[] = {
    {&SteadyFriction::a, parameter::direct_effect},
    {&SteadyFriction::b, parameter::positive_state_effect},
    {&SteadyFriction::slip_distance, parameter::slip_distance},
    {&SteadyFriction::reference_rate, parameter::reference_slip_rate},
    {&SteadyFriction::reference_friction, parameter::reference_friction},
  };

  Table table = {}; // set by LawStateKernels

  // The alpha [-] at which friction at V is f_ss(V).
  KOKKOS_INLINE_FUNCTION double steadyState(double V) const
  {
    constexpr double log10_of_e = 0.43429448190325182765;
    const double log_V = math::log(V);
    return stateOf(table(log10_of_e * log_V) / a, log_V - log_reference_rate);
  }
};
} // namespace asperity::friction
