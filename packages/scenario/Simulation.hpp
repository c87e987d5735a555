#pragma once

#include "base/CommandLine.hpp"
#include "dynamics/CoupledStep.hpp"
#include "io/Archive.hpp"
#include "io/OutputSet.hpp"
#include "io/RunLog.hpp"
#include "scenario/OutputFields.hpp"
#include "scenario/Problem.hpp"

#include <filesystem>
#include <memory>

namespace asperity::scenario
{
// A run: a problem, its steps, and what it leaves in a directory.
class Simulation
{
public:
  // `deck` is completed. Prepares the directory; reads the checkpoint of a restart. Collective.
  Simulation(RCP<ParameterList> const& deck, CommandLine const& command_line,
             RCP<const Communicator> const& communicator);
  ~Simulation();

  // To the final time, or until SIGTERM or SIGINT. Returns the exit status (base/MpiScope.hpp).
  // SolveError if even the smallest step fails; the last good state is on disk then.
  int run();

private:
  void begin();
  void advance();
  void writeCheckpoint();
  void report(bool finished);
  io::StepInfo stepInfo() const;
  bool atEnd() const;

  RCP<ParameterList> deck_;
  RCP<const Communicator> communicator_;
  std::filesystem::path directory_;
  std::unique_ptr<io::RunLog> log_;
  Problem problem_;
  dynamics::DyadicTime clock_;
  dynamics::DyadicTime::Ticks end_;
  std::unique_ptr<dynamics::StepSolvers> solvers_;
  std::unique_ptr<dynamics::CoupledStep> coupled_step_;
  std::unique_ptr<dynamics::StepControl> control_;
  dynamics::EnergyBalance balance_;
  dynamics::State state_;
  dynamics::SolveCount count_;
  std::int64_t forced_steps_ = 0;
  RunView view_;
  std::map<std::string, io::Location> locations_;
  io::FieldRegistry registry_;
  std::unique_ptr<io::OutputSet> outputs_;
  std::string restart_;
  io::Archive checkpoint_; // of a restart, until it begins
  int checkpoint_interval_;
};

// Where results go if the command line does not say: results/<name of the deck>.
std::filesystem::path outputDirectory(CommandLine const& command_line);
} // namespace asperity::scenario
