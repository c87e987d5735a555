#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/deck/CommandLine.hpp"
#include "scenario/report/RunReport.hpp"

#include <filesystem>
#include <memory>

namespace asperity::scenario
{
// A run: a problem, its steps, and the files that it writes to a directory.
class Simulation
{
public:
  virtual ~Simulation() = default;

  // Runs to the final time, or until SIGTERM or SIGINT. Returns the exit status
  // (base/program/MpiScope.hpp). Throws SolveError if even the smallest step fails; the last good
  // state is on disk then.
  virtual int run() = 0;

  // The first lines of the log, see RunReport.hpp. Collective.
  virtual Description description() const = 0;
};

// `deck` must be complete. Unless the command line says --validate, reads the checkpoint of a
// restart and prepares the directory. Collective.
std::unique_ptr<Simulation> makeSimulation(RCP<ParameterList> const& deck,
                                           CommandLine const& command_line,
                                           RCP<const Communicator> const& communicator);

// The directory of the results: that of the command line, or results/<name of the deck>.
std::filesystem::path outputDirectory(CommandLine const& command_line);
} // namespace asperity::scenario
