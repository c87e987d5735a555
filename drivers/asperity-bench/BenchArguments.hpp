#pragma once

#include "Scaling.hpp"
#include "base/program/CommandLine.hpp"

#include <iosfwd>

struct BenchArguments
{
  asperity::CommandLine deck; // the deck and its overrides
  ScalingOptions scaling;
  std::string output; // JSON file, "" for none
  bool help = false;
};

// InputError with the nearest name for an unknown option, or if something is missing or no number.
BenchArguments parseBenchArguments(int argc, char const* const* argv);

void printBenchHelp(std::ostream& out);
