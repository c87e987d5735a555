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
// Registration runs when the library is loaded, where nothing may be thrown; keep plugins in shared
// or object libraries. If two plugins have the same name, which is an error in the program, names
// and create throw std::logic_error.
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

  // False if the name is taken.
  bool add(std::string const& name, Factory factory)
  {
    const bool is_new = factories_.emplace(name, std::move(factory)).second;
    if (!is_new) {
      repeated_.push_back(name);
    }
    return is_new;
  }

  bool contains(std::string const& name) const { return factories_.count(name) > 0; }

  // The names of all registrations; a name that two plugins have appears twice.
  std::vector<std::string> registrations() const
  {
    auto all = sortedNames();
    all.insert(all.end(), repeated_.begin(), repeated_.end());
    return all;
  }

  // Sorted.
  std::vector<std::string> names() const
  {
    requireDistinctNames();
    return sortedNames();
  }

  // `path` is the place of the name in the deck; an unknown one is an InputError with the nearest.
  std::unique_ptr<Product> create(std::string const& name, std::string const& path,
                                  Arguments... arguments) const
  {
    requireDistinctNames();
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
  std::vector<std::string> sortedNames() const
  {
    std::vector<std::string> names;
    for (auto const& entry : factories_) {
      names.push_back(entry.first);
    }
    return names;
  }

  void requireDistinctNames() const
  {
    if (!repeated_.empty()) {
      throw std::logic_error("The plugin '" + repeated_.front() + "' is registered twice.");
    }
  }

  std::map<std::string, Factory> factories_;
  std::vector<std::string> repeated_; // names that are registered more than once
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
