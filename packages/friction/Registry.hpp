#pragma once

#include "friction/FrictionKernels.hpp"
#include "friction/LawProperties.hpp"
#include "friction/StateKernels.hpp"

#include <memory>
#include <string>
#include <vector>

// All laws by name: those of this package and those that other libraries or programs have
// registered (see Registration.hpp). A name that is not registered throws std::out_of_range, whose
// message lists the registered ones. A second law of the same name is a programming error: from
// then on every function but registeredLaws throws std::logic_error.
namespace asperity::friction
{
std::vector<std::string> frictionLawNames(); // sorted
FrictionLawProperties const& frictionLaw(std::string const& name);
std::vector<Parameter> const& frictionLawParameters(std::string const& name);

// Throws std::invalid_argument if the shapes of the views do not fit each other or the law's table.
std::unique_ptr<FrictionKernels> makeFrictionKernels(std::string const& name,
                                                     FaultView const& fault);

std::vector<std::string> stateLawNames(); // sorted
StateLawProperties const& stateLaw(std::string const& name);
std::vector<Parameter> const& stateLawParameters(std::string const& name);

// parameters(num_parameters, num_nodes) has its rows in the order of the law's table and is read
// once. Throws std::invalid_argument if it does not have that number of rows.
std::unique_ptr<StateKernels> makeStateKernels(std::string const& name, ParameterView parameters);

// "friction law 'Truncated'", "state law 'Slip'", ..., for each registration: a name that two laws
// have stands there twice.
std::vector<std::string> registeredLaws();
} // namespace asperity::friction
