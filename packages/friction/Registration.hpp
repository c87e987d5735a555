#pragma once

#include "friction/Registry.hpp"
#include "friction/detail/LawFrictionKernels.hpp"
#include "friction/detail/LawStateKernels.hpp"

#include <cstddef>
#include <memory>
#include <utility>

// These macros make a law known by its name and instantiate its kernels. Write one line at the
// bottom of a .cpp, in this package or in any other program or library. The library has to be a
// shared or an object library, since a static one drops such files.
//
//   ASPERITY_REGISTER_FRICTION_LAW(asperity::friction::RegularisedLaw)
//   ASPERITY_REGISTER_STATE_LAW(asperity::friction::AgeingLaw)
//
// README.md says what a law has to have.
#define ASPERITY_REGISTER_FRICTION_LAW(Law)                                                        \
  ASPERITY_REGISTER(::asperity::friction::FrictionLawRegistry, Law::name,                          \
                    ::asperity::friction::detail::RegisteredFrictionLaw<Law>)

#define ASPERITY_REGISTER_STATE_LAW(Law)                                                           \
  ASPERITY_REGISTER(::asperity::friction::StateLawRegistry, Law::name,                             \
                    ::asperity::friction::detail::RegisteredStateLaw<Law>)

namespace asperity::friction::detail
{
// The law's FUNCTION() of its parameters, or nullptr for a law that lacks it: int binds to the
// first where that compiles.
#define ASPERITY_OPTIONAL_FUNCTION(FUNCTION)                                                       \
  template <class Law>                                                                             \
  auto FUNCTION##Of(int)->decltype(std::declval<Law const&>().FUNCTION()) (*)(double const*)       \
  {                                                                                                \
    return [](double const* values) { return loadLaw<Law>(values).FUNCTION(); };                   \
  }                                                                                                \
  template <class Law>                                                                             \
  std::nullptr_t FUNCTION##Of(long)                                                                \
  {                                                                                                \
    return nullptr;                                                                                \
  }

ASPERITY_OPTIONAL_FUNCTION(sensitivity)
ASPERITY_OPTIONAL_FUNCTION(slipDistance)
ASPERITY_OPTIONAL_FUNCTION(thetaScale)
ASPERITY_OPTIONAL_FUNCTION(stressSensitivity)
ASPERITY_OPTIONAL_FUNCTION(referenceFriction)
ASPERITY_OPTIONAL_FUNCTION(strengthDrop)
#undef ASPERITY_OPTIONAL_FUNCTION

template <class Law>
auto stateVariableOf(int) -> decltype(Law::state_variable)
{
  return Law::state_variable;
}
template <class Law>
char const* stateVariableOf(long)
{
  return logarithm_of_theta;
}

template <class Law>
auto nucleationSourceOf(int) -> decltype(Law::nucleation_source)
{
  return Law::nucleation_source;
}
template <class Law>
char const* nucleationSourceOf(long)
{
  return nullptr;
}

template <class Law>
auto weakensAtHighRatesOf(int) -> decltype(Law::weakens_at_high_rates)
{
  return Law::weakens_at_high_rates;
}
template <class Law>
bool weakensAtHighRatesOf(long)
{
  return false;
}

template <class Law>
struct RegisteredFrictionLaw : FrictionLaw
{
  RegisteredFrictionLaw()
  {
    appendParameters<Law>(parameters);
    sensitivity = sensitivityOf<Law>(0);
    reference_friction = referenceFrictionOf<Law>(0);
    strength_drop = strengthDropOf<Law>(0);
    state_variable = stateVariableOf<Law>(0);
    make_kernels = [](FaultView const& fault) {
      return std::make_unique<LawFrictionKernels<Law>>(fault);
    };
  }
};

template <class Law>
struct RegisteredStateLaw : StateLaw
{
  RegisteredStateLaw()
  {
    appendParameters<Law>(parameters);
    slip_distance = slipDistanceOf<Law>(0);
    theta_scale = thetaScaleOf<Law>(0);
    stress_sensitivity = stressSensitivityOf<Law>(0);
    weakens_at_high_rates = weakensAtHighRatesOf<Law>(0);
    has_table = HasTable<Law>::value;
    nucleation_source = nucleationSourceOf<Law>(0);
    state_variable = stateVariableOf<Law>(0);
    make_kernels = [](ParameterView const& values, TableView const& table) {
      return std::make_unique<LawStateKernels<Law>>(values, table);
    };
  }
};
} // namespace asperity::friction::detail
