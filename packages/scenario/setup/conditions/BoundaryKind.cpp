#include "scenario/setup/conditions/BoundaryKind.hpp"

namespace asperity::scenario
{
std::vector<std::string> BoundaryKind::entries() const
{
  Declare own;
  declare(own);
  std::vector<std::string> names;
  for (auto const& entry : *own.list()) {
    names.push_back(entry.first);
  }
  if (readsDirection()) {
    names.push_back("Direction");
  }
  return names;
}
} // namespace asperity::scenario
