#include "friction/Registry.hpp"

#include "friction/Registration.hpp"

#include <map>
#include <stdexcept>
#include <utility>

namespace asperity::friction
{
namespace
{
template <class Properties, class Maker>
struct Entry
{
  Properties properties;
  Maker make;
};

template <class Properties, class Maker>
struct Laws
{
  std::string kind; // in messages
  std::map<std::string, Entry<Properties, Maker>> by_name;
  std::vector<std::string> repeated; // names that were taken
};

using FrictionLaws = Laws<FrictionLawProperties, FrictionKernelsMaker>;
using StateLaws = Laws<StateLawProperties, StateKernelsMaker>;

// The maps are static objects of functions, since registration may run before the static objects of
// this file exist.
FrictionLaws& frictionLaws()
{
  static FrictionLaws laws{"friction law", {}, {}};
  return laws;
}

StateLaws& stateLaws()
{
  static StateLaws laws{"state law", {}, {}};
  return laws;
}

template <class Properties, class Maker>
bool add(Laws<Properties, Maker>& laws, std::string const& name, Entry<Properties, Maker> entry)
{
  const bool is_new = laws.by_name.emplace(name, std::move(entry)).second;
  if (!is_new) {
    laws.repeated.push_back(name);
  }
  return is_new;
}

template <class AnyLaws>
void requireDistinctNames(AnyLaws const& laws)
{
  if (!laws.repeated.empty()) {
    throw std::logic_error("The " + laws.kind + " '" + laws.repeated.front() +
                           "' is registered twice.");
  }
}

template <class AnyLaws>
std::vector<std::string> names(AnyLaws const& laws)
{
  requireDistinctNames(laws);
  std::vector<std::string> result;
  for (auto const& law : laws.by_name) {
    result.push_back(law.first);
  }
  return result;
}

template <class AnyLaws>
auto const& find(AnyLaws const& laws, std::string const& name)
{
  requireDistinctNames(laws);
  const auto found = laws.by_name.find(name);
  if (found != laws.by_name.end()) {
    return found->second;
  }
  std::string known;
  for (auto const& law : laws.by_name) {
    known += (known.empty() ? "'" : ", '") + law.first + "'";
  }
  throw std::out_of_range("'" + name + "' is not a known " + laws.kind + ". Choose one of " +
                          known + ".");
}

template <class AnyLaws>
void describe(AnyLaws const& laws, std::vector<std::string>& all)
{
  for (auto const& law : laws.by_name) {
    all.push_back(laws.kind + " '" + law.first + "'");
  }
  for (auto const& name : laws.repeated) {
    all.push_back(laws.kind + " '" + name + "'");
  }
}
} // namespace

bool registerFrictionLaw(std::string const& name, FrictionLawProperties properties,
                         FrictionKernelsMaker make)
{
  return add(frictionLaws(), name, {std::move(properties), std::move(make)});
}

bool registerStateLaw(std::string const& name, StateLawProperties properties,
                      StateKernelsMaker make)
{
  return add(stateLaws(), name, {std::move(properties), std::move(make)});
}

std::vector<std::string> frictionLawNames() { return names(frictionLaws()); }

FrictionLawProperties const& frictionLaw(std::string const& name)
{
  return find(frictionLaws(), name).properties;
}

std::vector<Parameter> const& frictionLawParameters(std::string const& name)
{
  return frictionLaw(name).parameters;
}

std::unique_ptr<FrictionKernels> makeFrictionKernels(std::string const& name,
                                                     FaultView const& fault)
{
  return find(frictionLaws(), name).make(fault);
}

std::vector<std::string> stateLawNames() { return names(stateLaws()); }

StateLawProperties const& stateLaw(std::string const& name)
{
  return find(stateLaws(), name).properties;
}

std::vector<Parameter> const& stateLawParameters(std::string const& name)
{
  return stateLaw(name).parameters;
}

std::unique_ptr<StateKernels> makeStateKernels(std::string const& name, ParameterView parameters)
{
  return find(stateLaws(), name).make(std::move(parameters));
}

std::vector<std::string> registeredLaws()
{
  std::vector<std::string> all;
  describe(frictionLaws(), all);
  describe(stateLaws(), all);
  return all;
}
} // namespace asperity::friction
