#pragma once

#include "base/Archive.hpp"
#include "base/Types.hpp"
#include "base/Warning.hpp"
#include "io/files/Progress.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace asperity::io
{
// Numbers, and vectors of several, by name.
using Facts = std::map<std::string, std::vector<double>>;

// DIR/run.jsonl: what programs need to know of the course of a run, one JSON object a line, in
// addition to run.log, which is for people. Each object has `event`, `step` and `time` [s], and
//
//   begin    `clock`, the seconds since 1970; a process begins to write
//   fault    how the fault lies (catalogue/FaultFacts.hpp) and `one_sense`, which is
//            0 where the sense of positive slip differs between its parts
//   restart  the process goes on from the checkpoint of that step: what came after it is void
//   warning  `topic` and `text` (base/Warning.hpp); a restart repeats those up to its checkpoint,
//            with their own step and time
//   progress `wall_time` [s], `peak_slip_rate` [m/s] and, if they are known, `events` and, of wall
//            time, `seconds_left` with `knows_cycles` (TimeLeft)
//   end      `how` ("finished", "stopped", "failed"), `exit_status`, `message`, `wall_time` and, of
//            a failure, its `kind` (RunRecord.cpp); a process that is killed has no end
//
// The wall time is that of steps.csv: of all processes, without what a restart computes again.
// asperity.journal reads it. Only rank 0 writes. Not collective; a line that cannot be written is
// left out, since run.log has it, too.
class RunJournal
{
public:
  // Appends if `append` is true (after a restart), otherwise starts a new file.
  RunJournal(std::filesystem::path const& file, bool append, Communicator const& comm);

  // How far the run is: the step and the time that the lines to come have.
  void at(std::int64_t step, double time);

  void fault(Facts const& facts);
  void restart();
  void warn(Warning const& warning);
  // The topics of the warnings of the run, also of those that have been repeated.
  std::set<std::string> topics() const;
  void progress(Progress const& progress);
  // kind: of a failure, or "".
  void end(std::string const& how, int exit_status, std::string const& message, double wall_time,
           std::string const& kind = "");

  // Saves the last warning of each topic.
  void save(Archive& archive) const;
  // Repeats those that were saved and on whose topic this process has not warned; returns them.
  std::vector<Warning> repeat(Archive const& archive);

private:
  struct RecordedWarning
  {
    std::string text;
    std::int64_t step = 0;
    double time = 0;
  };
  void write(std::string const& event, std::string const& more);

  std::ofstream file_; // open on rank 0 alone
  std::int64_t step_ = 0;
  double time_ = 0;
  std::map<std::string, RecordedWarning> recorded_; // by topic
};
} // namespace asperity::io
