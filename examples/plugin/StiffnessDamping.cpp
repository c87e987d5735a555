// A law of bulk of your own: viscosities proportional to the moduli, sigma = B : (eps + b eps'), so
// that damping grows with frequency alike for all waves (the stiffness part of Rayleigh damping).
// fem/bulk/BulkLaw.hpp says what a law has to have.
#include "fem/bulk/BulkLaw.hpp"

namespace
{
using namespace asperity;

struct StiffnessDamping
{
  static constexpr char const* name = "Stiffness Damping";
  static constexpr Parameter parameters[] = {{"Damping Time", "s", no_default, 0, infinity, true,
                                              false,
                                              "Viscosities are the moduli times this time b."}};

  static void complete(double const* values, fem::Material& material)
  {
    material.bulk_viscosity = values[0] * material.bulk_modulus;
    material.shear_viscosity = values[0] * material.shear_modulus;
  }
};
} // namespace

ASPERITY_REGISTER_BULK_LAW(StiffnessDamping)
