#pragma once

#include "friction/Table.hpp"
#include "friction/laws/SteadyFriction.hpp"

namespace asperity::friction
{
// Steady friction from a table, f_ss > 0 by log10(V s/m). Friction still increases with V at a
// given state, whatever the table. Host and device; V >= 0 in m/s.
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

  Table table = {}; // given by LawStateKernels

  KOKKOS_INLINE_FUNCTION double steadyState(double V) const
  {
    constexpr double log10_of_e = 0.43429448190325182765;
    const double log_V = math::log(V);
    return stateOf(table(log10_of_e * log_V) / a, log_V - log_reference_rate);
  }
};
} // namespace asperity::friction
