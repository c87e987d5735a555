#pragma once

#include "base/Errors.hpp"
#include "base/NearestName.hpp"

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
// Plugins of one kind by name, each made from the same arguments:
//
//   using OutputRegistry = Registry<Output, ParameterList const&>; // in the header of the kind
//   ASPERITY_REGISTER(OutputRegistry, "Events", EventTable)        // the end of EventTable.cpp
//   auto output = OutputRegistry::instance().create("Events", "Asperity / Output", list);
//
// Registration runs when the library is loaded; keep plugins in shared or object libraries.
template <class Product, class... Arguments>
class Registry
{
public:
  using Factory = std::function<std::unique_ptr<Product>(Arguments...)>;

  static Registry& instance()
  {
    static Registry registry;
    return registry;
  }

  // Two plugins of one name are a mistake of ours: std::logic_error.
  void add(std::string const& name, Factory factory)
  {
    if (!factories_.emplace(name, std::move(factory)).second) {
      throw std::logic_error("The plugin '" + name + "' is registered twice.");
    }
  }

  bool contains(std::string const& name) const { return factories_.count(name) > 0; }

  // Sorted.
  std::vector<std::string> names() const
  {
    std::vector<std::string> names;
    for (auto const& entry : factories_) {
      names.push_back(entry.first);
    }
    return names;
  }

  // `path` is where the name was asked for; an unknown name is an InputError with the nearest one.
  std::unique_ptr<Product> create(std::string const& name, std::string const& path,
                                  Arguments... arguments) const
  {
    const auto found = factories_.find(name);
    ASPERITY_REQUIRE(found != factories_.end(),
                     path << ": '" << name << "' is unknown." << didYouMean(name, names()));
    return found->second(std::forward<Arguments>(arguments)...);
  }

  // An object of static storage duration that registers while it is constructed.
  struct Registration
  {
    Registration(std::string const& name, Factory factory)
    {
      instance().add(name, std::move(factory));
    }
  };

private:
  std::map<std::string, Factory> factories_;
};
} // namespace asperity

#define ASPERITY_CONCATENATE_EXPANDED(left, right) left##right
#define ASPERITY_CONCATENATE(left, right) ASPERITY_CONCATENATE_EXPANDED(left, right)

// Registers `type`, constructed from the registry's arguments. One per line of a .cpp.
#define ASPERITY_REGISTER(registry, name, type)                                                    \
  namespace                                                                                        \
  {                                                                                                \
  const registry::Registration ASPERITY_CONCATENATE(asperity_registration_,                        \
                                                    __LINE__)(name, [](auto&&... arguments) {      \
    return std::make_unique<type>(std::forward<decltype(arguments)>(arguments)...);                \
  });                                                                                              \
  }
