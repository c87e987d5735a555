#include "registry/Registry.hpp"

namespace asperity::detail
{
std::out_of_range unknownName(std::string const& kind, std::string const& name,
                              std::vector<std::string> const& names)
{
  std::string known;
  for (auto const& other : names) {
    known += (known.empty() ? "'" : ", '") + other + "'";
  }
  return std::out_of_range("'" + name + "' is not a known " + kind + ". Choose one of " + known +
                           ".");
}

std::logic_error repeatedName(std::string const& kind, std::string const& name)
{
  return std::logic_error("The " + kind + " '" + name + "' is registered twice.");
}
} // namespace asperity::detail
