#pragma once

#include <string>

namespace asperity
{
// What may make the results of a run wrong or useless. It stands in the log, in asperity-status and
// in asperity-report.
struct Warning
{
  std::string topic; // "cohesive zone": a later warning about the same topic takes its place
  std::string text;  // sentences, without "WARNING:" before them
};
} // namespace asperity
