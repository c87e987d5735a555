#include "fem/bulk/BulkLaw.hpp"

#include <cmath>

namespace asperity::fem
{
namespace
{
// A Maxwell element (G, eta) and a Kelvin element (G2, eta2) one after the other. At the complex
// rate p the modulus is
//   1 / G(p) = 1 / G + 1 / (eta p) + 1 / (G2 + eta2 p)
//   G(p) / G = p (p + b) / ((p + r1) (p + r2)) = sum of x_k p / (p + r_k),
// r1 < b < r2 the roots of r^2 - (a + b + c) r + a b with a = G / eta, b = G2 / eta2 and
// c = G / eta2.
struct Burgers
{
  static constexpr char const* name = "Burgers";

  double viscosity;               // eta [Pa s]
  double transient_viscosity;     // eta2 [Pa s]
  double transient_shear_modulus; // G2 [Pa]

  static constexpr ParameterOf<Burgers> parameters[] = {
    {&Burgers::viscosity,
     {"Viscosity", "Pa s", no_default, Range::positive(),
      "The rock flows with this viscosity in the long term (that of the Maxwell element)."}},
    {&Burgers::transient_viscosity,
     {"Transient Viscosity", "Pa s", no_default, Range::positive(),
      "This viscosity delays the transient part of the strain (that of the Kelvin element)."}},
    {&Burgers::transient_shear_modulus,
     {"Transient Shear Modulus", "Pa", no_default, Range::positive(),
      "This modulus bounds the transient part of the strain (that of the Kelvin element)."}}};

  std::vector<RelaxingShare> relaxation(Material const& material) const
  {
    const double G = material.shear_modulus;
    const double a = G / viscosity, b = transient_shear_modulus / transient_viscosity,
                 c = G / transient_viscosity;
    // r2 - r1, not below |a - b + c|
    const double between = std::hypot(a - b + c, 2 * std::sqrt(b * c));
    const double fast = (a + b + c + between) / 2;
    const double share_of_fast = (1 + (a - b + c) / between) / 2; // (r2 - b) / (r2 - r1)
    return {{1 - share_of_fast, fast / (a * b)}, {share_of_fast, 1 / fast}};
  }
};
} // namespace
} // namespace asperity::fem

ASPERITY_REGISTER_BULK_LAW(asperity::fem::Burgers)
