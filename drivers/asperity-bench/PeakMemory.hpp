#pragma once

#include <fstream>
#include <string>

// The largest memory that this process has used: VmHWM of the kernel, in bytes.
inline double peakBytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  }
  return 0;
}
