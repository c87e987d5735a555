#include "base/Errors.hpp"
#include "base/Text.hpp"
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
// With a dilation angle psi the volume grows by sin(psi) for each unit of inelastic shear strain,
// and by more at the apex of the cone, where rock opens. psi = phi is associated flow.
struct DruckerPrager : Yield
{
  static constexpr char const* name = "Drucker-Prager";

  double cohesion;       // c [Pa]
  double friction_angle; // phi [degrees]
  double dilation_angle; // psi [degrees]
  double sin_phi, sin_psi;
  double strength_without_pressure; // c cos(phi) [Pa]

  static constexpr ParameterOf<DruckerPrager> parameters[] = {
    {&DruckerPrager::cohesion,
     {"Cohesion", "Pa", no_default, Range::atLeast(0),
      "The rock has this cohesion: its shear strength without pressure is cohesion times the "
      "cosine of the friction angle."}},
    {&DruckerPrager::friction_angle,
     {"Friction Angle", "deg", no_default, Range::closedOpen(0, 90),
      "The shear strength of the rock grows with pressure by the sine of this angle of internal "
      "friction."}},
    {&DruckerPrager::hardening, parameter::hardening},
    {&DruckerPrager::relaxation_time, parameter::yield_relaxation},
    {&DruckerPrager::residual_share, parameter::residual_share},
    {&DruckerPrager::softening_shear, parameter::softening_shear},
    {&DruckerPrager::dilation_angle,
     {"Dilation Angle", "deg", 0, Range::closedOpen(0, 90),
      "The volume of rock that yields grows by the sine of this angle for each unit of inelastic "
      "shear strain, and it opens where tension exceeds what the cone bears. With the friction "
      "angle the flow is associated; it cannot be larger. It has no effect in antiplane models."}},
    {&DruckerPrager::shear_viscosity, parameter::shear_viscosity},
    {&DruckerPrager::bulk_viscosity, parameter::bulk_viscosity}};

  KOKKOS_FUNCTION void prepare()
  {
    constexpr double degree = 3.14159265358979323846 / 180;
    sin_phi = math::sin(friction_angle * degree);
    sin_psi = math::sin(dilation_angle * degree);
    strength_without_pressure = cohesion * math::cos(friction_angle * degree);
  }

  void complete(Material& material) const
  {
    ASPERITY_REQUIRE(dilation_angle <= friction_angle,
                     "Asperity / Bulk / Dilation Angle = "
                       << formatShort(dilation_angle)
                       << " degrees is larger than Friction Angle = " << formatShort(friction_angle)
                       << " degrees: rock that yields would gain energy.");
    Viscosity::complete(material);
  }

  KOKKOS_FUNCTION double shearStress(Trial const& trial) const { return returned(trial).shear; }
  KOKKOS_FUNCTION double meanStress(Trial const& trial) const { return returned(trial).mean; }

private:
  struct Stress
  {
    double shear, mean; // [Pa]
  };

  KOKKOS_FUNCTION Stress returned(Trial const& trial) const
  {
    const double H = hardening;
    const double without_stress = strength_without_pressure * softened(trial);
    const double strength = without_stress - trial.mean_stress * sin_phi;
    if (sin_psi == 0) {
      return {yielded(strength, trial), trial.mean_stress};
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
    const double left = leftOver(trial);
    return {at_last.shear + left * (trial.shear_stress - at_last.shear),
            at_last.mean + left * (trial.mean_stress - at_last.mean)};
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::DruckerPrager)
