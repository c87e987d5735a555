#include "fem/bulk/BulkLaw.hpp"
#include "fem/bulk/Viscosity.hpp"

namespace asperity::fem
{
namespace
{
// A spring and a dashpot side by side (Pipping 2014); elastic where both viscosities
// are zero.
struct KelvinVoigt : Viscosity
{
  static constexpr char const* name = "Kelvin-Voigt";
  static constexpr ParameterOf<Viscosity> parameters[] = {
    {&Viscosity::shear_viscosity, parameter::shear_viscosity},
    {&Viscosity::bulk_viscosity, parameter::bulk_viscosity}};
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::KelvinVoigt)
