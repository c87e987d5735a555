#pragma once

#include "friction/LawProperties.hpp"
#include "friction/detail/LawFrictionKernels.hpp"
#include "friction/detail/LawStateKernels.hpp"

#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>

// These macros make a law known by its name and instantiate its kernels. Write one line at the
// bottom of a .cpp, in this package or in any other program or library. The library has to be a
// shared or an object library, since a static one drops such files.
//
//   ASPERITY_REGISTER_FRICTION_LAW(asperity::friction::RegularisedLaw)
//   ASPERITY_REGISTER_STATE_LAW(asperity::friction::AgeingLaw)
//
// README.md says what a law has to have. Nothing is thrown here, since this runs before main and
// while a library is loaded: Registry.hpp says what happens to two laws of the same name.
namespace asperity::friction
{
using FrictionKernelsMaker = std::function<std::unique_ptr<FrictionKernels>(FaultView const&)>;
using StateKernelsMaker = std::function<std::unique_ptr<StateKernels>(ParameterView)>;

// False if the name is taken.
bool registerFrictionLaw(std::string const& name, FrictionLawProperties properties,
                         FrictionKernelsMaker make);
bool registerStateLaw(std::string const& name, StateLawProperties properties,
                      StateKernelsMaker make);

namespace detail
{
// A law may lack these functions. One whose type differs from LawProperties.hpp does not compile.
template <class Law, class = void>
struct SensitivityOf
{
  static std::function<Sensitivity(double const*)> function() { return {}; }
};
template <class Law>
struct SensitivityOf<Law, std::void_t<decltype(&Law::sensitivity)>>
{
  static std::function<Sensitivity(double const*)> function() { return &Law::sensitivity; }
};

template <class Law, class = void>
struct SlipDistanceOf
{
  static std::function<double(double const*)> function() { return {}; }
};
template <class Law>
struct SlipDistanceOf<Law, std::void_t<decltype(&Law::slipDistance)>>
{
  static std::function<double(double const*)> function() { return &Law::slipDistance; }
};

template <class Law, class = void>
struct ThetaScaleOf
{
  static std::function<double(double const*)> function() { return {}; }
};
template <class Law>
struct ThetaScaleOf<Law, std::void_t<decltype(&Law::thetaScale)>>
{
  static std::function<double(double const*)> function() { return &Law::thetaScale; }
};

template <class Law, class = void>
struct StressSensitivityOf
{
  static std::function<double(double const*)> function() { return {}; }
};
template <class Law>
struct StressSensitivityOf<Law, std::void_t<decltype(&Law::stressSensitivity)>>
{
  static std::function<double(double const*)> function() { return &Law::stressSensitivity; }
};
} // namespace detail

template <class Law>
bool registerFrictionLaw()
{
  return registerFrictionLaw(Law::name,
                             {{std::begin(Law::parameters), std::end(Law::parameters)},
                              detail::SensitivityOf<Law>::function()},
                             [](FaultView const& fault) -> std::unique_ptr<FrictionKernels> {
                               return std::make_unique<detail::LawFrictionKernels<Law>>(fault);
                             });
}

template <class Law>
bool registerStateLaw()
{
  return registerStateLaw(Law::name,
                          {{std::begin(Law::parameters), std::end(Law::parameters)},
                           detail::SlipDistanceOf<Law>::function(),
                           detail::ThetaScaleOf<Law>::function(),
                           detail::StressSensitivityOf<Law>::function()},
                          [](ParameterView const& parameters) -> std::unique_ptr<StateKernels> {
                            return std::make_unique<detail::LawStateKernels<Law>>(parameters);
                          });
}
} // namespace asperity::friction

#define ASPERITY_FRICTION_JOIN_EXPANDED(left, right) left##right
#define ASPERITY_FRICTION_JOIN(left, right) ASPERITY_FRICTION_JOIN_EXPANDED(left, right)

#define ASPERITY_REGISTER_FRICTION_LAW(Law)                                                        \
  namespace                                                                                        \
  {                                                                                                \
  [[maybe_unused]] const bool ASPERITY_FRICTION_JOIN(friction_law_registered_, __COUNTER__) =      \
    ::asperity::friction::registerFrictionLaw<Law>();                                              \
  }

#define ASPERITY_REGISTER_STATE_LAW(Law)                                                           \
  namespace                                                                                        \
  {                                                                                                \
  [[maybe_unused]] const bool ASPERITY_FRICTION_JOIN(state_law_registered_, __COUNTER__) =         \
    ::asperity::friction::registerStateLaw<Law>();                                                 \
  }
