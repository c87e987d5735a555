#pragma once

#include "base/program/CommandLine.hpp"
#include "compare/Compare.hpp"
#include "scaling/Scaling.hpp"
#include "steps/Steps.hpp"

#include <iosfwd>

struct BenchArguments
{
  asperity::CommandLine deck; // the deck and its overrides
  ScalingOptions scaling;
  StepsOptions steps;            // num_steps is 0 without `steps`
  CompareOptions compare;        // likewise for `compare`
  std::string output;            // JSON file, for stiffness a text file; "" for none
  bool counts_mesh = false;      // asperity-bench mesh
  bool writes_stiffness = false; // asperity-bench stiffness
  bool help = false;
};

// InputError with the nearest name if an option is unknown, or if something is missing or not a
// number.
BenchArguments parseBenchArguments(int argc, char const* const* argv);

void printBenchHelp(std::ostream& out);
