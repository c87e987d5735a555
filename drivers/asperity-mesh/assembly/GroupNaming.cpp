#include "assembly/GroupNaming.hpp"

#include "Warnings.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"

#include <algorithm>
#include <iostream>
#include <utility>
#include <vector>

namespace asperity::geometry
{
GroupNaming::GroupNaming(GivenNames const& given, std::string option, std::string what, Maker make)
    : given_(given)
    , option_(std::move(option))
    , what_(std::move(what))
    , make_(std::move(make))
{
}

std::string GroupNaming::renamed(std::string const& own)
{
  own_names_.insert(own);
  const auto given = given_.by_name.find(own);
  return given != given_.by_name.end() ? given->second : own;
}

std::string GroupNaming::nameOf(std::string const& own) { return boundaryName(renamed(own)); }

std::string GroupNaming::nameOf(std::int64_t number, std::string const& own)
{
  const auto known = of_number_.find(number);
  if (known != of_number_.end()) {
    return known->second;
  }
  auto& name = of_number_[number];
  const auto given = std::find_if(given_.by_number.begin(), given_.by_number.end(),
                                  [&](auto const& item) { return item.first == number; });
  if (given != given_.by_number.end()) {
    name = given->second;
  } else if (!own.empty()) {
    name = renamed(own);
  } else {
    name = make_(number);
    const auto text = std::to_string(number);
    remarks_ += what_ + ' ' + text + " is called '" + name + "'; " + option_ + ' ' + text +
                "=NAME gives another name\n";
  }
  return name = boundaryName(name);
}

void GroupNaming::finish(std::string const& where) const
{
  const std::vector<std::string> names(own_names_.begin(), own_names_.end());
  for (auto const& [own, name] : given_.by_name) {
    requireKnownName(option_, own, names, where);
  }
  std::cout << remarks_;
  for (auto const& [number, name] : given_.by_number) {
    if (of_number_.count(number) == 0) {
      std::string present;
      for (auto const& item : of_number_) {
        present += (present.empty() ? "" : ", ") + std::to_string(item.first);
      }
      warn("Option " + option_ + ' ' + std::to_string(number) + '=' + name +
           " names nothing: " + where + " has no " + what_ + ' ' + std::to_string(number) +
           ", only " + (present.empty() ? "none" : present) + '.');
    }
  }
}

std::string boundaryName(std::string name)
{
  std::replace(name.begin(), name.end(), '/', '_');
  return name == "." ? "_" : name;
}
} // namespace asperity::geometry
