#include "fem/bulk/BulkLaw.hpp"
#include "fem/bulk/Viscosity.hpp"

namespace asperity::fem
{
namespace
{
// A spring and a dashpot side by side (Pipping 2014); elastic where both viscosities
// are zero.
struct KelvinVoigt
{
  static constexpr char const* name = "Kelvin-Voigt";
  static constexpr Parameter parameters[] = {shear_viscosity, bulk_viscosity};

  static void complete(double const* values, Material& material)
  {
    setViscosity(values[0], values[1], material);
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::KelvinVoigt)
