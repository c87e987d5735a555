#include "friction/Registry.hpp"

#include <utility>

namespace asperity::friction
{
FrictionLawRegistry const& frictionLaws() { return FrictionLawRegistry::instance(); }

StateLawRegistry const& stateLaws() { return StateLawRegistry::instance(); }

std::unique_ptr<FrictionKernels> makeFrictionKernels(std::string const& law, FaultView const& fault)
{
  return frictionLaws().at(law).make_kernels(fault);
}

std::unique_ptr<StateKernels> makeStateKernels(std::string const& law, ParameterView parameters)
{
  return stateLaws().at(law).make_kernels(std::move(parameters));
}
} // namespace asperity::friction
