#pragma once

#include "fem/bulk/Material.hpp"
#include "fem/bulk/ReturnMapping.hpp"
#include "portability/Parameter.hpp"
#include "portability/Registry.hpp"

#include <functional>
#include <iterator>
#include <memory>
#include <type_traits>
#include <vector>

// All laws of bulk by name. A law is a class with a name, a table of parameters, and functions of
// the values of the parameters at the centroid of a cell, in the order of the table:
//
//   struct KelvinVoigt
//   {
//     static constexpr char const* name = "Kelvin-Voigt";
//     static constexpr Parameter parameters[] = {{"Shear Viscosity", "Pa s", ...}, ...};
//     static void complete(double* values, Material& material);
//     static std::vector<RelaxingShare> relaxation(double const* values, Material const& material);
//     KOKKOS_FUNCTION static double shearStress(double const* values, Trial const& trial);
//   };
//   ASPERITY_REGISTER_BULK_LAW(KelvinVoigt) // the end of its .cpp
//
// complete() sets the viscosities of a material that has density and elastic moduli; it may replace
// values by what the other functions take, as an angle by its sine. relaxation() tells which shares
// of its shear modulus relax (MaxwellBranch); shearStress() is t1 of rock that yields, or creeps
// faster than stress grows (ReturnMapping.hpp); where it also dilates, a function meanStress()
// beside it is p1. A law has at least one of the three, and not the last two together.
namespace asperity::fem
{
// A share in [0, 1] of the shear modulus and its relaxation time [s]; the shares of a cell sum to
// at most 1. Maxwell: {1, eta / G}.
struct RelaxingShare
{
  double share = 0, time = 0;
};

struct BulkLaw
{
  static constexpr char const* registered_as = "bulk law";
  std::vector<Parameter> parameters;
  std::function<void(double* values, Material& material)> complete;
  std::function<std::vector<RelaxingShare>(double const* values, Material const& material)>
    relaxation;
  // Makes a step of the cells of this law; empty: they do not yield.
  std::function<void(YieldingCells const&)> yield;
};
using BulkLawRegistry = Registry<BulkLaw>;

// A function of this library, so that the linker does not drop its laws where it is called.
BulkLawRegistry const& bulkLaws();

namespace detail
{
template <class Law, class = void>
struct Completes : std::false_type
{
};
template <class Law>
struct Completes<Law, std::void_t<decltype(&Law::complete)>> : std::true_type
{
};
template <class Law, class = void>
struct Relaxes : std::false_type
{
};
template <class Law>
struct Relaxes<Law, std::void_t<decltype(&Law::relaxation)>> : std::true_type
{
};

template <class Law, class = void>
struct Yields : std::false_type
{
};
template <class Law>
struct Yields<Law, std::void_t<decltype(&Law::shearStress)>> : std::true_type
{
};

template <class Law>
struct RegisteredBulkLaw : BulkLaw
{
  RegisteredBulkLaw()
  {
    static_assert(Completes<Law>::value || Relaxes<Law>::value || Yields<Law>::value,
                  "A law of bulk has complete(), relaxation() or shearStress()");
    static_assert(!(Relaxes<Law>::value && Yields<Law>::value),
                  "A law of bulk has relaxation() or shearStress(), not both");
    parameters.assign(std::begin(Law::parameters), std::end(Law::parameters));
    complete = [](double*, Material&) {};
    relaxation = [](double const*, Material const&) { return std::vector<RelaxingShare>(); };
    if constexpr (Completes<Law>::value) {
      complete = &Law::complete;
    }
    if constexpr (Relaxes<Law>::value) {
      relaxation = &Law::relaxation;
    }
    if constexpr (Yields<Law>::value) {
      yield = [](YieldingCells const& cells) { ReturnMapping<Law>{cells}.run(); };
    }
  }
};
} // namespace detail
} // namespace asperity::fem

#define ASPERITY_REGISTER_BULK_LAW(Law)                                                            \
  ASPERITY_REGISTER(::asperity::fem::BulkLawRegistry, Law::name,                                   \
                    ::asperity::fem::detail::RegisteredBulkLaw<Law>)
