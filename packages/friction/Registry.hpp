#pragma once

#include "friction/FrictionKernels.hpp"
#include "friction/LawProperties.hpp"
#include "friction/StateKernels.hpp"
#include "friction/Table.hpp"
#include "registry/Registry.hpp"

#include <functional>
#include <memory>
#include <string>

// All laws by name: those of this package and those that other libraries or programs have
// registered (see Registration.hpp).
namespace asperity::friction
{
struct FrictionLaw : FrictionLawProperties
{
  static constexpr char const* registered_as = "friction law";
  std::function<std::unique_ptr<FrictionKernels>(FaultView const&)> make_kernels;
};
using FrictionLawRegistry = Registry<FrictionLaw>;

struct StateLaw : StateLawProperties
{
  static constexpr char const* registered_as = "state law";
  std::function<std::unique_ptr<StateKernels>(ParameterView, TableView)> make_kernels;
};
using StateLawRegistry = Registry<StateLaw>;

// Functions of this library, so that the linker does not drop its laws where these are called.
FrictionLawRegistry const& frictionLaws();
StateLawRegistry const& stateLaws();

// Throws std::invalid_argument if the shapes of the views do not fit each other or the law's table.
std::unique_ptr<FrictionKernels> makeFrictionKernels(std::string const& law,
                                                     FaultView const& fault);

// parameters(num_parameters, num_nodes) has its rows in the order of the law's table and is read
// once; the table is for a law that has one. Throws std::invalid_argument if it does not have that
// number of rows, or the table is missing.
std::unique_ptr<StateKernels> makeStateKernels(std::string const& law, ParameterView parameters,
                                               TableView table = {});
} // namespace asperity::friction
