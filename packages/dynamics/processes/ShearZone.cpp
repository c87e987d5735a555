#include "dynamics/processes/ShearZone.hpp"

#include "base/Errors.hpp"
#include "base/Types.hpp"
#include "dynamics/MeanDecay.hpp"
#include "portability/Renamed.hpp"

#include <cmath>

namespace asperity::dynamics
{
namespace
{
// The range of k w above 0. Beyond the largest lies 2e-9 of the integral of the transform of g.
// Below the smallest, modes do not decay: heat that has spread over w / 1e-8, after 1e16 w^2 /
// alpha_th, stays at the fault.
constexpr double smallest_wavenumber = 1e-8, largest_wavenumber = 6;

// What a step does to a mode at a node.
struct ModeStep
{
  double x_th;                           // alpha_th k^2 tau
  double thermal_decay, hydraulic_decay; // over the step
  double pressure_per_temperature;       // Th before the step also drives ph [Pa/K]
  double pressure_per_heat;              // [Pa m per W/m^2]
};

// With x = alpha k^2 tau: the rate of Th in the step, (s q - alpha_th k^2 Th) exp(-alpha_th k^2 t)
// with s = source / (rho c), drives ph, of which
//   integral of exp(-alpha_hy k^2 (tau - t) - alpha_th k^2 t) dt
//     = tau exp(-min(x_th, x_hy)) meanDecay(|x_th - x_hy|)
// remains.
KOKKOS_INLINE_FUNCTION ModeStep modeStep(ShearZone::Properties const& zone, int node,
                                         double wavenumber, double source, double tau)
{
  const double k = wavenumber / zone.half_width(node);
  const double thermal_rate = zone.thermal_diffusivity(node) * k * k;
  const double x_th = thermal_rate * tau, x_hy = zone.hydraulic_diffusivity(node) * k * k * tau;
  const bool is_thermal_less = x_th < x_hy;
  const double difference = is_thermal_less ? x_hy - x_th : x_th - x_hy;
  const double change = math::expm1(-difference);
  const double larger = math::exp(-(is_thermal_less ? x_th : x_hy));
  const double smaller = larger * (1 + change);
  const double driven = zone.pressure_per_temperature(node) * tau * larger *
                        (difference > 0 ? -change / difference : 1);
  return {x_th, is_thermal_less ? larger : smaller, is_thermal_less ? smaller : larger,
          -thermal_rate * driven, source / zone.heat_capacity(node) * driven};
}
} // namespace

ShearZone::ShearZone(Properties properties, int num_modes) : properties_(std::move(properties))
{
  ASPERITY_ASSERT(num_modes >= 3);
  const int num_positive = num_modes - 1;
  const double spacing = std::log(largest_wavenumber / smallest_wavenumber) / (num_positive - 1);
  for (int i = 0; i < num_positive; ++i) {
    const double D = largest_wavenumber * std::exp(-spacing * i);
    modes_.push_back({D, std::exp(-D * D / 2), spacing * D / M_PI});
  }
  // The sum over the rest of the grid, where the modes are those of k = 0.
  modes_.push_back({0, 1, spacing * smallest_wavenumber / (M_PI * std::expm1(spacing))});
}

void ShearZone::pressureAfter(Modes const& before, double tau, NodeView const& rest,
                              NodeView const& per_heat) const
{
  Kokkos::deep_copy(rest, properties_.pressure);
  Kokkos::deep_copy(per_heat, 0.);
  auto const zone = properties_;
  for (int i = 0; i < numModes(); ++i) {
    const double wavenumber = modes_[i].wavenumber, source = modes_[i].source,
                 weight = modes_[i].weight;
    const ConstNodeView Th = before.temperature[i], ph = before.pressure[i];
    Kokkos::parallel_for(
      "asperity::dynamics::pressureAfter", RangePolicy(0, rest.extent_int(0)),
      KOKKOS_LAMBDA(int node) {
        auto const step = modeStep(zone, node, wavenumber, source, tau);
        const double at_fault = weight / zone.half_width(node);
        rest(node) +=
          at_fault * (step.hydraulic_decay * ph(node) + step.pressure_per_temperature * Th(node));
        per_heat(node) += at_fault * step.pressure_per_heat;
      });
  }
}

void ShearZone::advance(Modes const& before, double tau, ConstNodeView const& q, Modes const& after,
                        NodeView const& temperature) const
{
  Kokkos::deep_copy(temperature, properties_.temperature);
  auto const zone = properties_;
  for (int i = 0; i < numModes(); ++i) {
    const double wavenumber = modes_[i].wavenumber, source = modes_[i].source,
                 weight = modes_[i].weight;
    const ConstNodeView Th0 = before.temperature[i], ph0 = before.pressure[i];
    const NodeView Th = after.temperature[i], ph = after.pressure[i];
    Kokkos::parallel_for(
      "asperity::dynamics::advanceModes", RangePolicy(0, temperature.extent_int(0)),
      KOKKOS_LAMBDA(int node) {
        auto const step = modeStep(zone, node, wavenumber, source, tau);
        const double of_temperature = Th0(node); // after may be before
        const double warming = source / zone.heat_capacity(node) * tau * meanDecay(step.x_th);
        Th(node) = step.thermal_decay * of_temperature + warming * q(node);
        ph(node) = step.hydraulic_decay * ph0(node) +
                   step.pressure_per_temperature * of_temperature +
                   step.pressure_per_heat * q(node);
        temperature(node) += weight / zone.half_width(node) * Th(node);
      });
  }
}
} // namespace asperity::dynamics
