#pragma once

#include "base/Archive.hpp"
#include "base/Warning.hpp"
#include "io/files/RunJournal.hpp"
#include "io/files/RunLog.hpp"

#include <exception>
#include <filesystem>
#include <set>
#include <string>

namespace asperity::io
{
// What a run says of its course: run.log for people, run.jsonl for programs, the wall time of all
// its processes and the time left. Only rank 0 writes; not collective.
class RunRecord
{
public:
  // In the directory of a run; appends if `goes_on` (a restart), otherwise starts new files. Throws
  // InputError on every rank if the log cannot be opened.
  RunRecord(std::filesystem::path const& directory, bool goes_on, Communicator const& comm);

  // The time of all processes of the run, without what a restart computes again [s].
  double wallTime() const;
  // How far the run is, for the lines of the journal to come.
  void at(std::int64_t step, double time) { journal_.at(step, time); }

  void message(std::string const& text) { log_.message(text); }
  void warn(Warning const& warning);
  // For programs that read the results.
  void fault(Facts const& facts) { journal_.fault(facts); }
  // The topics of the warnings of the run.
  std::set<std::string> topics() const { return journal_.topics(); }
  // Adds the time left.
  void progress(Progress progress);

  void end(std::string const& how, int exit_status);
  // The error goes to standard error in another way.
  void fail(std::exception const& error);

  // restore() also notes the restart, and repeats the warnings of the run before it: what they say
  // of its results holds for those that follow from them.
  void save(Archive& archive) const;
  void restore(Archive const& archive);
  // Repeats the warnings of another run, whose state this one begins with.
  void inherit(Archive const& archive);

private:
  void repeat(Archive const& archive, std::string const& whose);

  bool active_; // rank 0
  RunLog log_;
  RunJournal journal_;
  TimeLeft time_left_;
  double earlier_wall_time_ = 0; // of earlier processes of the run, up to the checkpoint [s]
};
} // namespace asperity::io
