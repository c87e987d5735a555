#include "scenario/Registrations.hpp"

#include "friction/Registry.hpp"
#include "io/Output.hpp"
#include "io/TextFormat.hpp"
#include "scenario/setup/fault/FaultKind.hpp"

namespace asperity::scenario
{
std::vector<std::string> registrations()
{
  auto all = friction::registeredLaws();
  for (auto const& name : io::OutputRegistry::instance().registrations()) {
    all.push_back("output '" + name + "'");
  }
  for (auto const& name : io::TextFormatRegistry::instance().registrations()) {
    all.push_back("text format '" + name + "'");
  }
  for (auto const& name : FaultKindRegistry::instance().registrations()) {
    all.push_back("kind of fault '" + name + "'");
  }
  return all;
}
} // namespace asperity::scenario
