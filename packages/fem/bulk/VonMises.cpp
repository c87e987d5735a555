#include "fem/bulk/BulkLaw.hpp"
#include "fem/bulk/Yield.hpp"

namespace asperity::fem
{
namespace
{
// Elastic up to a shear stress t = sqrt(s : s / 2) that may grow with the inelastic shear:
//   t <= k + H gamma, where k may fall with gamma
struct VonMises : Yield
{
  static constexpr char const* name = "Von Mises";

  double strength; // k [Pa]

  static constexpr ParameterOf<VonMises> parameters[] = {
    {&VonMises::strength,
     {"Shear Strength", "Pa", no_default, Range::positive(),
      "The rock yields at this shear stress, sqrt(s : s / 2) of its deviatoric part s."}},
    {&VonMises::hardening, parameter::hardening},
    {&VonMises::relaxation_time, parameter::yield_relaxation},
    {&VonMises::residual_share, parameter::residual_share},
    {&VonMises::softening_shear, parameter::softening_shear},
    {&VonMises::shear_viscosity, parameter::shear_viscosity},
    {&VonMises::bulk_viscosity, parameter::bulk_viscosity}};

  KOKKOS_FUNCTION double shearStress(Trial const& trial) const
  {
    return yielded(strength * softened(trial), trial);
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::VonMises)
