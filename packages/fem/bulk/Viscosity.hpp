#pragma once

#include "fem/bulk/Material.hpp"
#include "registry/LawParameters.hpp"

namespace asperity::fem
{
namespace parameter
{
inline constexpr Parameter shear_viscosity = {
  "Shear Viscosity", "Pa s", 0, Range::atLeast(0),
  "This viscosity resists changes of shape (Kelvin-Voigt)."};
inline constexpr Parameter bulk_viscosity = {
  "Bulk Viscosity", "Pa s", 0, Range::atLeast(0),
  "This viscosity resists changes of volume (Kelvin-Voigt)."};
} // namespace parameter

// The dashpot parallel to the spring of a law (Kelvin and Voigt), which damps waves.
struct Viscosity
{
  double shear_viscosity; // Pa s
  double bulk_viscosity;  // Pa s

  void complete(Material& material) const
  {
    material.shear_viscosity = shear_viscosity;
    material.bulk_viscosity = bulk_viscosity;
  }
};
} // namespace asperity::fem
