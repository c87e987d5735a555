#include "fem/bulk/BulkLaw.hpp"

namespace asperity::fem
{
namespace
{
// A spring and a dashpot one after the other: all shear stress relaxes, and the rock flows.
// s' = 2 G e' - s G / eta
struct Maxwell
{
  static constexpr char const* name = "Maxwell";

  double viscosity; // eta [Pa s]

  static constexpr ParameterOf<Maxwell> parameters[] = {
    {&Maxwell::viscosity,
     {"Viscosity", "Pa s", no_default, Range::positive(),
      "The rock flows with this viscosity. Its stress falls to 1/e in the relaxation time, "
      "viscosity over shear modulus, at constant strain."}}};

  std::vector<RelaxingShare> relaxation(Material const& material) const
  {
    return {{1, viscosity / material.shear_modulus}};
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::Maxwell)
