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
  static constexpr Parameter parameters[5] = {DirectEffect::table[0], b_parameter, L_parameter,
                                              reference_slip_rate, DirectEffect::table[3]};

  Table table = {}; // given by LawStateKernels

  // Reads column `node` of values(num_parameters, num_nodes), rows in the order of the table.
  KOKKOS_INLINE_FUNCTION static TabulatedLaw load(ParameterView const& values, int node)
  {
    return {SteadyFriction::load(values, node)};
  }

  KOKKOS_INLINE_FUNCTION double steadyState(double V) const
  {
    constexpr double log10_of_e = 0.43429448190325182765;
    const double log_V = math::log(V);
    return stateOf(table(log10_of_e * log_V) / a, log_V - log_reference_slip_rate);
  }
};
} // namespace asperity::friction
