#pragma once

#include <cmath>

namespace asperity::fem
{
// What is constant in a cell of an isotropic body:
//   sigma = B : eps(u) + A : eps(u'),  B = (bulk - 2/3 shear) tr + 2 shear,
// A likewise with the viscosities, which a law of bulk sets (bulk/BulkLaw.hpp).
// In plane strain the moduli are those of three dimensions; antiplane uses the shear values alone.
struct Material
{
  double density = 0;         // kg/m^3
  double bulk_modulus = 0;    // Pa
  double shear_modulus = 0;   // Pa
  double bulk_viscosity = 0;  // Pa s
  double shear_viscosity = 0; // Pa s

  // Traction per velocity of a plane wave, rho cs and rho cp [Pa s/m].
  double shearImpedance() const { return std::sqrt(density * shear_modulus); }
  double compressionalImpedance() const
  {
    return std::sqrt(density * (bulk_modulus + 4. / 3 * shear_modulus));
  }

  double poissonsRatio() const
  {
    return (3 * bulk_modulus - 2 * shear_modulus) / (2 * (3 * bulk_modulus + shear_modulus));
  }
};
} // namespace asperity::fem
