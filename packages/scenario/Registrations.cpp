#include "scenario/Registrations.hpp"

#include "friction/Registry.hpp"
#include "io/Output.hpp"

namespace asperity::scenario
{
std::vector<std::string> registrations()
{
  auto all = friction::registeredLaws();
  for (auto const& name : io::OutputRegistry::instance().registrations()) {
    all.push_back("output '" + name + "'");
  }
  return all;
}
} // namespace asperity::scenario
