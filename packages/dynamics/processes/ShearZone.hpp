#pragma once

#include "portability/Views.hpp"

#include <vector>

namespace asperity::dynamics
{
// Heat and fluid in the zone across each node of a fault in which slip is spread, with y across the
// zone, temperature T and pressure p:
//   T_t = alpha_th T_yy + q g(y) / (rho c),   p_t = alpha_hy p_yy + Lambda T_t,
// with g the normal distribution of standard deviation w, and q [W/m^2] the friction that slip has
// to work against. No flow along the fault.
//
// The solution by modes in y (Noda and Lapusta 2010, doi:10.1029/2010JB007780),
//   Th(k) = integral of (T - T0) cos(k y) dy [K m],   ph(k) likewise [Pa m],
// is exact in a step of constant q, whatever the two diffusivities are. Values at y = 0 are 1 / pi
// of the integral over k >= 0, by the trapezoidal rule in ln k. The last mode has k = 0: Th(0) is
// the heat of the zone over rho c, and stands for all modes below the smallest k.
class ShearZone
{
public:
  // All (num_nodes) and positive, but for the two initial values.
  struct Properties
  {
    ConstNodeView thermal_diffusivity;      // alpha_th [m^2/s]
    ConstNodeView hydraulic_diffusivity;    // alpha_hy [m^2/s]
    ConstNodeView heat_capacity;            // rho c [J/(m^3 K)]
    ConstNodeView pressure_per_temperature; // Lambda [Pa/K]
    ConstNodeView half_width;               // w [m]
    ConstNodeView temperature;              // T0 [K]
    ConstNodeView pressure;                 // p0 [Pa]
  };
  // A view (num_nodes) for each mode.
  struct Modes
  {
    std::vector<NodeView> temperature; // Th [K m]
    std::vector<NodeView> pressure;    // ph [Pa m]
  };

  // num_modes >= 3, k = 0 among them; with 60 the values at y = 0 are exact to 1e-5.
  ShearZone(Properties properties, int num_modes);

  int numModes() const { return static_cast<int>(modes_.size()); }
  Properties const& properties() const { return properties_; }

  // How p at y = 0 at the end of a step of tau [s] depends on the mean q of the step:
  // p = rest + per_heat q, with rest [Pa] and per_heat [Pa m^2/W] (num_nodes).
  void pressureAfter(Modes const& before, double tau, NodeView const& rest,
                     NodeView const& per_heat) const;

  // The modes at the end of that step with q(num_nodes) [W/m^2], and T(num_nodes) [K] at y = 0.
  void advance(Modes const& before, double tau, ConstNodeView const& q, Modes const& after,
               NodeView const& temperature) const;

private:
  struct Mode
  {
    double wavenumber; // k w
    double source;     // exp(-(k w)^2 / 2), the transform of g
    double weight;     // of the mode in values at y = 0, times w
  };

  Properties properties_;
  std::vector<Mode> modes_;
};
} // namespace asperity::dynamics
