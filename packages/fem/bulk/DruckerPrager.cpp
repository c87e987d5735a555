#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "fem/bulk/BulkLaw.hpp"
#include "fem/bulk/Viscosity.hpp"
#include "fem/bulk/Yield.hpp"

#include <cmath>

namespace asperity::fem
{
namespace
{
// Elastic up to a shear stress that grows with the pressure (Andrews 2005), tension positive:
//   t <= max(0, c cos(phi) - mean stress sin(phi)) + H gamma, where c may fall with gamma
// In plane strain this is Mohr and Coulomb's law with cohesion c and friction angle phi where the
// stress across the plane is the mean of the other two.
// With a dilation angle psi the volume grows by sin(psi) for each unit of inelastic shear strain,
// and by more at the apex of the cone, where rock opens. psi = phi is associated flow.
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
    softening_shear,
    {"Dilation Angle", "deg", 0, 0, 90, true, false,
     "The volume of rock that yields grows by the sine of this angle for each unit of inelastic "
     "shear strain, and it opens where tension exceeds what the cone bears. With the friction "
     "angle the flow is associated; it cannot be larger. It has no effect in antiplane models."},
    shear_viscosity,
    bulk_viscosity};

  // Replaces the cohesion by c cos(phi) and the angles by their sines.
  static void complete(double* values, Material& material)
  {
    ASPERITY_REQUIRE(values[6] <= values[1],
                     "Asperity / Bulk / Dilation Angle = "
                       << formatShort(values[6])
                       << " degrees is larger than Friction Angle = " << formatShort(values[1])
                       << " degrees: rock that yields would gain energy.");
    setViscosity(values[7], values[8], material);
    constexpr double degree = 3.14159265358979323846 / 180;
    values[0] *= std::cos(values[1] * degree);
    values[1] = std::sin(values[1] * degree);
    values[6] = std::sin(values[6] * degree);
  }

  KOKKOS_FUNCTION static double shearStress(double const* values, Trial const& trial)
  {
    return returned(values, trial).shear;
  }

  KOKKOS_FUNCTION static double meanStress(double const* values, Trial const& trial)
  {
    return returned(values, trial).mean;
  }

private:
  struct Stress
  {
    double shear, mean; // [Pa]
  };

  KOKKOS_FUNCTION static Stress returned(double const* values, Trial const& trial)
  {
    const double sin_phi = values[1], sin_psi = values[6], H = values[2], time = values[3];
    const double without_stress = values[0] * softened(values[4], values[5], trial);
    const double strength = without_stress - trial.mean_stress * sin_phi;
    if (sin_psi == 0) {
      return {yielded(strength, H, time, trial), trial.mean_stress};
    }
    const double over = trial.shear_stress - strength - H * trial.shear;
    if (over <= 0) {
      return {trial.shear_stress, trial.mean_stress};
    }
    const double G = trial.shear_modulus, K = trial.bulk_modulus;
    const double change = over / (G + H + K * sin_phi * sin_psi); // of gamma
    Stress at_last = {trial.shear_stress - G * change, trial.mean_stress - K * sin_psi * change};
    if (at_last.shear < 0) { // the apex, which moves with gamma
      const double gamma = trial.shear + trial.shear_stress / G;
      at_last = {0, (without_stress + H * gamma) / sin_phi};
    }
    const double kept = time > 0 ? math::exp(-trial.step / time) : 0;
    return {at_last.shear + kept * (trial.shear_stress - at_last.shear),
            at_last.mean + kept * (trial.mean_stress - at_last.mean)};
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::DruckerPrager)
