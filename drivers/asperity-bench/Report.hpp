#pragma once

#include <string>

// What a command has measured: to read, and for programs (--output).
struct Report
{
  std::string table;
  std::string file;
};
