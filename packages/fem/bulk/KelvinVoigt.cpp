#include "fem/bulk/BulkLaw.hpp"

namespace asperity::fem
{
namespace
{
// A spring and a dashpot side by side (Pipping 2014); elastic where both viscosities
// are zero.
struct KelvinVoigt
{
  static constexpr char const* name = "Kelvin-Voigt";
  static constexpr Parameter parameters[] = {
    {"Shear Viscosity", "Pa s", 0, 0, infinity, true, false,
     "This viscosity resists changes of shape (Kelvin-Voigt)."},
    {"Bulk Viscosity", "Pa s", 0, 0, infinity, true, false,
     "This viscosity resists changes of volume (Kelvin-Voigt)."}};

  static void complete(double const* values, Material& material)
  {
    material.shear_viscosity = values[0];
    material.bulk_viscosity = values[1];
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::KelvinVoigt)
