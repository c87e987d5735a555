#pragma once

#include <chrono>
#include <string>

// What a command has measured: to read, and for programs (--output).
struct Report
{
  std::string table;
  std::string file;
};

// Of a clock that never goes back [s].
inline double wallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
