#pragma once

#include "base/Archive.hpp"
#include "dynamics/State.hpp"

#include <string>

namespace asperity::dynamics
{
// Keeps states in an archive, for those who remember some.
class StateArchive
{
public:
  virtual ~StateArchive() = default;
  virtual void save(Archive& archive, std::string const& path, State const& state) const = 0;
  // Throws InputError if the archive has no such state, or one of another mesh. Collective.
  virtual State load(Archive const& archive, std::string const& path) const = 0;
};
} // namespace asperity::dynamics
