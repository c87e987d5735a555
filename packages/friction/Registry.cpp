#include "friction/Registry.hpp"

#include <stdexcept>
#include <utility>

namespace asperity::friction
{
FrictionLawRegistry const& frictionLaws() { return FrictionLawRegistry::instance(); }

StateLawRegistry const& stateLaws() { return StateLawRegistry::instance(); }

std::unique_ptr<FrictionKernels> makeFrictionKernels(std::string const& law, FaultView const& fault)
{
  return frictionLaws().at(law).make_kernels(fault);
}

std::unique_ptr<StateKernels> makeStateKernels(std::string const& law, ParameterView parameters,
                                               TableView table)
{
  auto const& chosen = stateLaws().at(law);
  if (chosen.has_table && table.extent(0) == 0) {
    throw std::invalid_argument("asperity::friction: " + law + " needs a table.");
  }
  return chosen.make_kernels(std::move(parameters), std::move(table));
}
} // namespace asperity::friction
