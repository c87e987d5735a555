#include "scenario/setup/fault/FaultKind.hpp"

namespace asperity::scenario
{
std::vector<std::string> faultKinds() { return FaultKindRegistry::instance().names(); }

std::vector<std::string> faultKindsInside()
{
  std::vector<std::string> inside;
  for (auto const& name : faultKinds()) {
    if (FaultKindRegistry::instance().create(name, "")->other_side.is_inside) {
      inside.push_back(name);
    }
  }
  return inside;
}
} // namespace asperity::scenario
