#include "fem/bulk/BulkLaw.hpp"
#include "fem/bulk/Yield.hpp"

namespace asperity::fem
{
namespace
{
// Elastic up to a shear stress that grows with the pressure (Andrews 2005), tension positive:
//   t <= max(0, c cos(phi) - mean stress sin(phi)) + H gamma, where c may fall with gamma
// In plane strain this is Mohr and Coulomb's law with cohesion c and friction angle phi where the
// stress across the plane is the mean of the other two.
struct DruckerPrager
{
  static constexpr char const* name = "Drucker-Prager";
  static constexpr Parameter parameters[] = {
    {"Cohesion", "Pa", no_default, 0, infinity, true, false,
     "The rock has this cohesion: its shear strength without pressure is cohesion times the cosine "
     "of the friction angle."},
    {"Friction Angle", "deg", no_default, 0, 90, true, false,
     "The shear strength of the rock grows with pressure by the sine of this angle of internal "
     "friction."},
    hardening,
    yield_relaxation,
    residual_share,
    softening_shear};

  KOKKOS_FUNCTION static double shearStress(double const* values, Trial const& trial)
  {
    const double phi = values[1] * 3.14159265358979323846 / 180;
    const double c = values[0] * softened(values[4], values[5], trial);
    const double strength = c * math::cos(phi) - trial.mean_stress * math::sin(phi);
    return yielded(strength, values[2], values[3], trial);
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::DruckerPrager)
