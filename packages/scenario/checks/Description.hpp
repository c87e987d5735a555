#pragma once

#include "base/Warning.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity::scenario
{
// What the log says of a run before its first step.
struct Description
{
  std::vector<std::string> lines;
  std::vector<Warning> warnings;

  void add(std::vector<std::string> const& more);
  void add(std::vector<Warning> const& more);
};

void print(Description const& description, std::ostream& stream);
} // namespace asperity::scenario
