#include "io/Output.hpp"

#include "base/Errors.hpp"

namespace asperity::io
{
OutputDomain const& OutputContext::domain(std::string const& name) const
{
  const auto found = domains.find(name);
  ASPERITY_REQUIRE(found != domains.end(),
                   "Output: this problem has no "
                     << name
                     << " to write. Set `Enabled` to false in the output's list, or name the "
                     << name << " in the deck.");
  return found->second;
}
} // namespace asperity::io
