#pragma once

namespace asperity::fem
{
// An isotropic Kelvin-Voigt body, constant in a cell:
//   sigma = B : eps(u) + A : eps(u'),  B = (bulk - 2/3 shear) tr + 2 shear,
// A likewise with the viscosities.
// In plane strain the moduli are those of three dimensions; antiplane uses the shear values alone.
struct Material
{
  double density = 0;         // kg/m^3
  double bulk_modulus = 0;    // Pa
  double shear_modulus = 0;   // Pa
  double bulk_viscosity = 0;  // Pa s
  double shear_viscosity = 0; // Pa s
};
} // namespace asperity::fem
