#pragma once

#include "friction/Parameter.hpp"
#include "friction/detail/LawFrictionKernels.hpp"
#include "friction/detail/LawStateKernels.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

// Makes a law known by its name and instantiates its kernels; one line at the bottom of a .cpp, in
// this package or in anybody's library or program (shared or object: a static library drops such
// files):
//
//   ASPERITY_REGISTER_FRICTION_LAW(asperity::friction::RegularisedLaw)
//   ASPERITY_REGISTER_STATE_LAW(asperity::friction::AgeingLaw)
//
// README.md says what a law has to have. Two laws of one name are a mistake of ours:
// std::logic_error.
namespace asperity::friction
{
using FrictionKernelsMaker = std::function<std::unique_ptr<FrictionKernels>(FaultData const&)>;
using StateKernelsMaker = std::function<std::unique_ptr<StateKernels>(ParameterView)>;

bool registerFrictionLaw(std::string const& name, std::vector<Parameter> parameters,
                         FrictionKernelsMaker make);
bool registerStateLaw(std::string const& name, std::vector<Parameter> parameters,
                      StateKernelsMaker make);

template <class Law>
bool registerFrictionLaw()
{
  return registerFrictionLaw(Law::name, {std::begin(Law::parameters), std::end(Law::parameters)},
                             [](FaultData const& fault) -> std::unique_ptr<FrictionKernels> {
                               return std::make_unique<detail::LawFrictionKernels<Law>>(fault);
                             });
}

template <class Law>
bool registerStateLaw()
{
  return registerStateLaw(Law::name, {std::begin(Law::parameters), std::end(Law::parameters)},
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
  [[maybe_unused]] const bool ASPERITY_FRICTION_JOIN(friction_law_registered_, __LINE__) =         \
    ::asperity::friction::registerFrictionLaw<Law>();                                              \
  }

#define ASPERITY_REGISTER_STATE_LAW(Law)                                                           \
  namespace                                                                                        \
  {                                                                                                \
  [[maybe_unused]] const bool ASPERITY_FRICTION_JOIN(state_law_registered_, __LINE__) =            \
    ::asperity::friction::registerStateLaw<Law>();                                                 \
  }
