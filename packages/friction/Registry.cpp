#include "friction/Registry.hpp"

#include "friction/Registration.hpp"

#include <map>
#include <stdexcept>
#include <utility>

namespace asperity::friction
{
namespace
{
template <class Maker>
struct Entry
{
  std::vector<Parameter> parameters;
  Maker make;
};

template <class Maker>
using Laws = std::map<std::string, Entry<Maker>>;

// Inside functions: registration runs before the static objects of this file need exist.
Laws<FrictionKernelsMaker>& frictionLaws()
{
  static Laws<FrictionKernelsMaker> laws;
  return laws;
}

Laws<StateKernelsMaker>& stateLaws()
{
  static Laws<StateKernelsMaker> laws;
  return laws;
}

template <class Maker>
bool add(Laws<Maker>& laws, std::string const& name, Entry<Maker> entry)
{
  if (!laws.emplace(name, std::move(entry)).second) {
    throw std::logic_error("asperity::friction: the law '" + name + "' is registered twice.");
  }
  return true;
}

template <class Maker>
std::vector<std::string> names(Laws<Maker> const& laws)
{
  std::vector<std::string> result;
  for (auto const& law : laws) {
    result.push_back(law.first);
  }
  return result;
}

template <class Maker>
Entry<Maker> const& find(Laws<Maker> const& laws, std::string const& kind, std::string const& name)
{
  const auto found = laws.find(name);
  if (found != laws.end()) {
    return found->second;
  }
  std::string known;
  for (auto const& law : laws) {
    known += (known.empty() ? "'" : ", '") + law.first + "'";
  }
  throw std::out_of_range("'" + name + "' is no " + kind + "; known are " + known + ".");
}
} // namespace

bool registerFrictionLaw(std::string const& name, std::vector<Parameter> parameters,
                         FrictionKernelsMaker make)
{
  return add(frictionLaws(), name, {std::move(parameters), std::move(make)});
}

bool registerStateLaw(std::string const& name, std::vector<Parameter> parameters,
                      StateKernelsMaker make)
{
  return add(stateLaws(), name, {std::move(parameters), std::move(make)});
}

std::vector<std::string> frictionLawNames() { return names(frictionLaws()); }

std::vector<Parameter> const& frictionLawParameters(std::string const& name)
{
  return find(frictionLaws(), "friction law", name).parameters;
}

std::unique_ptr<FrictionKernels> makeFrictionKernels(std::string const& name,
                                                     FaultData const& fault)
{
  return find(frictionLaws(), "friction law", name).make(fault);
}

std::vector<std::string> stateLawNames() { return names(stateLaws()); }

std::vector<Parameter> const& stateLawParameters(std::string const& name)
{
  return find(stateLaws(), "state law", name).parameters;
}

std::unique_ptr<StateKernels> makeStateKernels(std::string const& name, ParameterView parameters)
{
  return find(stateLaws(), "state law", name).make(parameters);
}
} // namespace asperity::friction
