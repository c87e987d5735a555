#pragma once

#include "fem/bulk/Material.hpp"
#include "portability/Parameter.hpp"

// The dashpot beside the spring of a law (Kelvin and Voigt), which damps waves.
namespace asperity::fem
{
inline constexpr Parameter shear_viscosity = {
  "Shear Viscosity", "Pa s", 0,     0,
  infinity,          true,   false, "This viscosity resists changes of shape (Kelvin-Voigt)."};
inline constexpr Parameter bulk_viscosity = {
  "Bulk Viscosity", "Pa s", 0,     0,
  infinity,         true,   false, "This viscosity resists changes of volume (Kelvin-Voigt)."};

inline void setViscosity(double shear, double bulk, Material& material)
{
  material.shear_viscosity = shear;
  material.bulk_viscosity = bulk;
}
} // namespace asperity::fem
