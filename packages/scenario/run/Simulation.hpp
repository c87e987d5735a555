#pragma once

#include "base/parallel/MeetingPoint.hpp"
#include "base/program/Signals.hpp"
#include "io/files/OutputDirectory.hpp"
#include "io/files/RunRecord.hpp"
#include "scenario/run/PreparedRun.hpp"

#include <exception>
#include <string>

namespace asperity::scenario
{
// A run with the directory that it writes to.
template <int Dim>
class Simulation
{
public:
  // Takes the directory and begins its log. Outputs that cannot be continued are refused before the
  // log and the parameters are touched; other tables may have been cut back to
  // the checkpoint by then, as any restart does. `prepared` must outlive this. Collective.
  Simulation(PreparedRun<Dim>& prepared, CommandLine const& command_line);

  // Runs to the final time, or until a signal to stop (base/program/Signals.hpp). Returns the exit
  // status (base/program/MpiScope.hpp). Throws SolveError if even the smallest step fails; the last
  // good state is on disk then. Collective.
  int run();

private:
  void describeStart();
  void recordFault();
  int makeSteps(StopSignals const& signals);
  void begin();
  void advance();
  void write(io::StepInfo const& info);
  void recordProgress(io::StepInfo const& info);
  void writeCheckpoint();
  void watch();
  void recordFailure(std::exception const& error);
  void saveCompleteSteps();
  void report(bool finished);

  PreparedRun<Dim>& prepared_;
  Evolution<Dim>& evolution_; // of prepared_
  io::OutputSet& outputs_;    // of prepared_
  MeetingPoint meeting_point_;
  std::string restart_, restart_from_;
  Description of_start_;   // before the directory is taken, since it may refuse the run
  io::DirectoryLock lock_; // on rank 0
  io::RunRecord record_;
  bool step_is_complete_ = false; // counted in the energy balance and written to the outputs
};
} // namespace asperity::scenario
