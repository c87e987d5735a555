#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
namespace detail
{
// What at() throws for a name that is not among the names: a kind, such as "output".
std::out_of_range unknownName(std::string const& kind, std::string const& name,
                              std::vector<std::string> const& names);
std::logic_error repeatedName(std::string const& kind, std::string const& name);
} // namespace detail

// What is registered of one kind, a class that says in `registered_as` what to call it in messages:
//
//   using OutputRegistry = Registry<OutputKind>;            // OutputKind::registered_as = "output"
//   ASPERITY_REGISTER(OutputRegistry, "Events", EventTable) // the end of EventTable.cpp
//   OutputRegistry::instance().at("Events").files()
//
// Registration runs when the library is loaded, where nothing may be thrown; keep what registers in
// shared or object libraries. If a name is registered twice, which is an error in the program,
// names and at throw std::logic_error.
template <class Kind>
class Registry
{
public:
  static Registry& instance()
  {
    static Registry registry;
    return registry;
  }

  // False if the name is taken.
  bool add(std::string const& name, std::shared_ptr<const Kind> registered)
  {
    const bool is_new = by_name_.emplace(name, std::move(registered)).second;
    if (!is_new) {
      repeated_.push_back(name);
    }
    return is_new;
  }

  // Sorted.
  std::vector<std::string> names() const
  {
    requireDistinctNames();
    std::vector<std::string> names;
    for (auto const& item : by_name_) {
      names.push_back(item.first);
    }
    return names;
  }

  // std::out_of_range, with the registered names, if the name is not registered.
  Kind const& at(std::string const& name) const
  {
    requireDistinctNames();
    const auto found = by_name_.find(name);
    if (found != by_name_.end()) {
      return *found->second;
    }
    throw detail::unknownName(Kind::registered_as, name, names());
  }

  // "output 'Events'" for each registration; what is registered twice occurs twice.
  std::vector<std::string> registrations() const
  {
    std::vector<std::string> all;
    for (auto const& item : by_name_) {
      all.push_back(described(item.first));
    }
    for (auto const& name : repeated_) {
      all.push_back(described(name));
    }
    return all;
  }

private:
  static std::string described(std::string const& name)
  {
    return std::string(Kind::registered_as) + " '" + name + "'";
  }

  void requireDistinctNames() const
  {
    if (!repeated_.empty()) {
      throw detail::repeatedName(Kind::registered_as, repeated_.front());
    }
  }

  std::map<std::string, std::shared_ptr<const Kind>> by_name_;
  std::vector<std::string> repeated_; // names that were taken
};
} // namespace asperity

#define ASPERITY_CONCATENATE_EXPANDED(left, right) left##right
#define ASPERITY_CONCATENATE(left, right) ASPERITY_CONCATENATE_EXPANDED(left, right)

// Registers an object of the type, which is a Kind and is made without arguments.
#define ASPERITY_REGISTER(registry, name, type)                                                    \
  namespace                                                                                        \
  {                                                                                                \
  [[maybe_unused]] const bool ASPERITY_CONCATENATE(asperity_registered_, __COUNTER__) =            \
    registry::instance().add(name, std::make_shared<const type>());                                \
  }
