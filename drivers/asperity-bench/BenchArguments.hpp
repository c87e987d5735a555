#pragma once

#include "Report.hpp"

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/deck/CommandLine.hpp"

#include <iosfwd>
#include <string>

namespace asperity::bench
{
struct BenchArguments;

// A row of the table of commands in BenchArguments.cpp.
struct BenchCommand
{
  std::string name, arguments, meaning; // as --help prints them
  bool counts_steps;                    // takes --steps, and needs it
  // `deck` is complete. Collective.
  Report (*measure)(ParameterList const& deck, BenchArguments const& arguments,
                    RCP<const Communicator> const& communicator);
};

struct BenchArguments
{
  BenchCommand const* command = nullptr; // none for --help
  CommandLine deck;                      // the deck, its overrides and plugins
  int num_steps = 0;                     // with --steps
  std::string output;                    // file for the numbers, "" for none
  bool help = false;
};

// InputError with the nearest name if an option is unknown, or if something is missing or not a
// number.
BenchArguments parseBenchArguments(int argc, char const* const* argv);

void printBenchHelp(std::ostream& out);
} // namespace asperity::bench
