#pragma once

#include "scenario/deck/CommandLine.hpp"

#include <iosfwd>
#include <string>

struct BenchArguments
{
  std::string command;        // steps, kernels or stiffness
  asperity::CommandLine deck; // the deck, its overrides and plugins
  int num_steps = 0;          // of `steps`
  std::string output;         // file for the numbers, "" for none
  bool help = false;
};

// InputError with the nearest name if an option is unknown, or if something is missing or not a
// number.
BenchArguments parseBenchArguments(int argc, char const* const* argv);

void printBenchHelp(std::ostream& out);
