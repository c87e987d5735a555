#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"
#include "base/program/CommandLine.hpp"

#include <filesystem>
#include <memory>

namespace asperity::scenario
{
// A run: a problem, its steps, and what it leaves in a directory.
class Simulation
{
public:
  virtual ~Simulation() = default;

  // To the final time, or until SIGTERM or SIGINT. Returns the exit status (base/MpiScope.hpp).
  // SolveError if even the smallest step fails; the last good state is on disk then.
  virtual int run() = 0;
};

// `deck` is completed. Prepares the directory; reads the checkpoint of a restart. Collective.
std::unique_ptr<Simulation> makeSimulation(RCP<ParameterList> const& deck,
                                           CommandLine const& command_line,
                                           RCP<const Communicator> const& communicator);

// Where results go if the command line does not say: results/<name of the deck>.
std::filesystem::path outputDirectory(CommandLine const& command_line);
} // namespace asperity::scenario
