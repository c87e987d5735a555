#include "fem/bulk/BulkLaw.hpp"
#include "fem/bulk/Viscosity.hpp"
#include "fem/bulk/Yield.hpp"

namespace asperity::fem
{
namespace
{
// Elastic up to a shear stress t = sqrt(s : s / 2) that may grow with the inelastic shear:
//   t <= k + H gamma, where k may fall with gamma
struct VonMises
{
  static constexpr char const* name = "Von Mises";
  static constexpr Parameter parameters[] = {
    {"Shear Strength", "Pa", no_default, 0, infinity, false, false,
     "The rock yields at this shear stress, sqrt(s : s / 2) of its deviatoric part s."},
    hardening,
    yield_relaxation,
    residual_share,
    softening_shear,
    shear_viscosity,
    bulk_viscosity};

  static void complete(double const* values, Material& material)
  {
    setViscosity(values[5], values[6], material);
  }

  KOKKOS_FUNCTION static double shearStress(double const* values, Trial const& trial)
  {
    const double k = values[0] * softened(values[3], values[4], trial);
    return yielded(k, values[1], values[2], trial);
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::VonMises)
