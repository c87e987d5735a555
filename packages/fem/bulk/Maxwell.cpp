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
  static constexpr Parameter parameters[] = {{"Viscosity", "Pa s", no_default, 0, infinity, false,
                                              false,
                                              "The rock flows with this viscosity. Its stress "
                                              "falls to 1/e in the relaxation time, viscosity "
                                              "over shear modulus, at constant strain."}};

  static std::vector<RelaxingShare> relaxation(double const* values, Material const& material)
  {
    return {{1, values[0] / material.shear_modulus}};
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::Maxwell)
