#pragma once

#include <string>

namespace asperity
{
// A condition that may make the results of a run wrong or useless. Shown in the log, by
// asperity-status and by asperity-report.
struct Warning
{
  std::string topic; // e.g. "cohesive zone"; a later warning on the same topic replaces this one
  std::string text;  // full sentences, without the prefix "WARNING:"
};
} // namespace asperity
