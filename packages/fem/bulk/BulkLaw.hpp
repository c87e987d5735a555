#pragma once

#include "fem/Material.hpp"
#include "portability/Parameter.hpp"
#include "portability/Registry.hpp"

#include <functional>
#include <iterator>
#include <memory>
#include <vector>

// All laws of bulk by name. A law is a class with a name, a table of parameters, and a function
// that completes the material of a cell:
//
//   struct KelvinVoigt
//   {
//     static constexpr char const* name = "Kelvin-Voigt";
//     static constexpr Parameter parameters[] = {{"Shear Viscosity", "Pa s", ...}, ...};
//     static void complete(double const* values, Material& material);
//   };
//   ASPERITY_REGISTER_BULK_LAW(KelvinVoigt) // the end of its .cpp
//
// values: of the parameters at the centroid of the cell, in the order of the table. Density and
// elastic moduli are in the material already; the law sets its viscosities.
namespace asperity::fem
{
struct BulkLaw
{
  static constexpr char const* registered_as = "bulk law";
  std::vector<Parameter> parameters;
  std::function<void(double const* values, Material& material)> complete;
};
using BulkLawRegistry = Registry<BulkLaw>;

// A function of this library, so that the linker does not drop its laws where it is called.
BulkLawRegistry const& bulkLaws();

namespace detail
{
template <class Law>
struct RegisteredBulkLaw : BulkLaw
{
  RegisteredBulkLaw()
  {
    parameters.assign(std::begin(Law::parameters), std::end(Law::parameters));
    complete = &Law::complete;
  }
};
} // namespace detail
} // namespace asperity::fem

#define ASPERITY_REGISTER_BULK_LAW(Law)                                                            \
  ASPERITY_REGISTER(::asperity::fem::BulkLawRegistry, Law::name,                                   \
                    ::asperity::fem::detail::RegisteredBulkLaw<Law>)
