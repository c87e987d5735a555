#pragma once

#include "parameters/Deck.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
// What the user asked of `asperity` on the command line. An empty string was not given.
struct CommandLine
{
  std::string deck;
  std::vector<std::string> overlays; // short XML files laid over the deck, in their order
  std::vector<std::string>
    overrides; // "Path/To/Parameter=value", after the removals, in their order
  std::vector<std::string> removals; // "Path/To/Entry", after the overlays
  std::vector<std::string> plugins;  // shared libraries, in their order
  std::string output;                // directory
  std::string restart;               // checkpoint file, or the directory of a run
  std::string restart_from;          // directory of another run, or its checkpoint
  bool validate = false;             // check the input, compute nothing
  bool overwrite = false;            // replace an existing result
  bool print_parameters = false;
  ParameterFormat format = ParameterFormat::text;
  bool help = false;
  bool version = false;
};

// With --restart: takes from the directory of the checkpoint what is not given. `restart` becomes
// the name of the checkpoint file, `output` its directory, and `deck` the parameters.xml there,
// which has the deck's values with all overlays and overrides. InputError if that is not there.
void completeRestart(CommandLine& line);

// InputError on an unknown option (with the nearest valid one), a missing value, a second or
// missing deck.
CommandLine parseCommandLine(int argc, char const* const* argv);

void printHelp(std::ostream& out);
} // namespace asperity
