#include "io/files/RunRecord.hpp"

#include "base/Errors.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/WorkTimers.hpp"

namespace asperity::io
{
namespace
{
// What programs tell failures apart by, whatever the message says.
std::string kindOf(std::exception const& error)
{
  if (dynamic_cast<UselessRun const*>(&error) != nullptr) {
    return "useless_run";
  }
  switch (exitStatus(error)) {
  case exit_input: return "input";
  case exit_solve: return "solve";
  case exit_output: return "output";
  default: return "other";
  }
}
} // namespace

RunRecord::RunRecord(std::filesystem::path const& directory, bool goes_on, Communicator const& comm)
    : active_(comm.getRank() == 0)
    , log_(directory / "run.log", goes_on, comm)
    , journal_(directory / "run.jsonl", goes_on, comm)
{
}

double RunRecord::wallTime() const { return earlier_wall_time_ + secondsSinceStart(); }

void RunRecord::warn(Warning const& warning)
{
  log_.message("WARNING: " + warning.text);
  journal_.warn(warning);
}

void RunRecord::progress(Progress progress)
{
  if (!active_) {
    return;
  }
  time_left_.note(progress.time, progress.wall_time, progress.num_events.value_or(0));
  progress.left = time_left_.estimate(progress.final_time);
  if (log_.progress(progress)) {
    journal_.progress(progress);
  }
}

void RunRecord::end(std::string const& how, int exit_status)
{
  journal_.end(how, exit_status, "", wallTime());
}

void RunRecord::fail(std::exception const& error)
{
  log_.note(std::string("The run has ended: ") + error.what());
  journal_.end("failed", exitStatus(error), error.what(), wallTime(), kindOf(error));
}

void RunRecord::save(Archive& archive) const
{
  archive.set("wall_time", wallTime());
  archive.insert("time_left", time_left_);
  archive.insert("warnings", journal_);
}

void RunRecord::restore(Archive const& archive)
{
  earlier_wall_time_ = archive.getDouble("wall_time");
  time_left_.restore(archive.child("time_left"));
  journal_.restart();
  repeat(archive, "The run before this restart");
}

void RunRecord::inherit(Archive const& archive)
{
  repeat(archive, "The run whose state this one begins with");
}

void RunRecord::repeat(Archive const& archive, std::string const& whose)
{
  const auto warnings = journal_.repeat(archive.child("warnings"));
  if (!warnings.empty()) {
    log_.message(whose + " has warned:");
  }
  for (auto const& warning : warnings) {
    log_.message("WARNING: " + warning.text);
  }
}
} // namespace asperity::io
