#pragma once

#include <chrono>
#include <string>

namespace asperity::bench
{
// What a command has measured: a table to read, and a file for programs (--output).
struct Report
{
  std::string table;
  std::string file;
};

// The time of a monotonic clock [s].
inline double wallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
} // namespace asperity::bench
