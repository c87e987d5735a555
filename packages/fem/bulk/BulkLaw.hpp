#pragma once

#include "fem/bulk/Material.hpp"
#include "fem/bulk/ReturnMapping.hpp"
#include "registry/LawParameters.hpp"
#include "registry/Registry.hpp"

#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

// All laws of bulk by name. A law is a struct with a name, the values of its parameters at the
// centroid of a cell (registry/LawParameters.hpp), and functions of these:
//
//   struct KelvinVoigt
//   {
//     static constexpr char const* name = "Kelvin-Voigt";
//     double shear_viscosity; // Pa s
//     static constexpr ParameterOf<KelvinVoigt> parameters[] = {
//       {&KelvinVoigt::shear_viscosity, {"Shear Viscosity", "Pa s", ...}}, ...};
//     void complete(Material& material) const;
//     std::vector<RelaxingShare> relaxation(Material const& material) const;
//     KOKKOS_FUNCTION double shearStress(Trial const& trial) const;
//   };
//   ASPERITY_REGISTER_BULK_LAW(KelvinVoigt) // the end of its .cpp
//
// complete() sets the viscosities of a material that has density and elastic moduli, and refuses
// values that contradict each other. relaxation() tells which shares of its shear modulus relax
// (MaxwellBranch); shearStress() is t1 of rock that yields, or creeps faster than stress grows
// (ReturnMapping.hpp); where it also dilates, a function meanStress() beside it is p1. Rock that
// remembers more than its inelastic strain has variables of its own (History.hpp) and, in place of
// shearStress(),
//
//   KOKKOS_FUNCTION InelasticChange respond(TrialStress const& stress, Trial const& trial,
//                                           History& history) const;
//
// which updates the history. The stress at the end of a step has to be the gradient of a convex
// potential of the strain there. A law has at least one of complete(), relaxation() and what
// yields, and not the last two together.
namespace asperity::fem
{
// A share in [0, 1] of the shear modulus and its relaxation time [s]; the shares of a cell sum to
// at most 1. Maxwell: {1, eta / G}.
struct RelaxingShare
{
  double share = 0, time = 0;
};

// Makes a step of cells that yield.
using YieldKernel = std::function<void(YieldingCells const&)>;

// Values of the parameters of one cell are in the order of the table.
struct BulkLaw
{
  static constexpr char const* registered_as = "bulk law";
  std::vector<Parameter> parameters;
  std::function<void(double const* values, Material& material)> complete;
  std::function<std::vector<RelaxingShare>(double const* values, Material const& material)>
    relaxation;
  // The variables that the law remembers, for tensors of so many components.
  std::function<std::vector<HistoryColumns>(int tensor_components)> history;
  // For cells with the parameters of values(num_cells, num_parameters); empty: they do not yield.
  std::function<YieldKernel(ConstTensorView const& values)> make_kernel;

  bool yields() const { return static_cast<bool>(make_kernel); }
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
struct Yields<Law, std::void_t<typename Law::History>> : std::true_type
{
};

template <class Law>
struct RegisteredBulkLaw : BulkLaw
{
  RegisteredBulkLaw()
  {
    static_assert(Completes<Law>::value || Relaxes<Law>::value || Yields<Law>::value,
                  "A law of bulk has complete(), relaxation(), shearStress() or a History");
    static_assert(!(Relaxes<Law>::value && Yields<Law>::value),
                  "A law of bulk relaxes or yields, not both");
    appendParameters<Law>(parameters);
    history = &historyColumns<Law>;
    complete = [](double const*, Material&) {};
    relaxation = [](double const*, Material const&) { return std::vector<RelaxingShare>(); };
    if constexpr (Completes<Law>::value) {
      complete = [](double const* values, Material& material) {
        loadLaw<Law>(values).complete(material);
      };
    }
    if constexpr (Relaxes<Law>::value) {
      relaxation = [](double const* values, Material const& material) {
        return loadLaw<Law>(values).relaxation(material);
      };
    }
    if constexpr (Yields<Law>::value) {
      make_kernel = [](ConstTensorView const& values) -> YieldKernel {
        return [laws = loadLaws<Law>(values)](YieldingCells const& cells) {
          ReturnMapping<Law>{laws, cells}.run();
        };
      };
    }
  }
};
} // namespace detail
} // namespace asperity::fem

#define ASPERITY_REGISTER_BULK_LAW(Law)                                                            \
  ASPERITY_REGISTER(::asperity::fem::BulkLawRegistry, Law::name,                                   \
                    ::asperity::fem::detail::RegisteredBulkLaw<Law>)
