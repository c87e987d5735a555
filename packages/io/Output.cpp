#include "io/Output.hpp"

#include "base/Errors.hpp"

namespace asperity::io
{
Location const& OutputContext::location(std::string const& name) const
{
  const auto found = locations.find(name);
  ASPERITY_REQUIRE(found != locations.end(),
                   "Output: this problem has no "
                     << name
                     << " to write. Set `Enabled` to false in the output's list, or name the "
                     << name << " in the deck.");
  return found->second;
}
} // namespace asperity::io
