#pragma once

#include "io/checkpoint/Checkpoint.hpp"
#include "scenario/fields/Domains.hpp"
#include "scenario/problem/Problem.hpp"
#include "scenario/setup/CheckpointSetup.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The sets of nodes to which values in a checkpoint of the problem may belong, by name.
template <int Dim>
NodeSets nodeSets(Problem<Dim> const& problem, Domains const& domains);

// The checkpoints of a run: when one is due, and what a restart must match.
class Checkpoints
{
public:
  // plugins: files of libraries.
  Checkpoints(std::filesystem::path const& directory, CheckpointIntervals const& intervals,
              std::vector<std::string> const& plugins, io::Fingerprint fingerprint,
              RCP<const Communicator> const& communicator);

  std::filesystem::path file() const { return directory_ / "checkpoint.h5"; }

  // The checkpoint of a restart. InputError, on every rank, if the deck or the content of the
  // plugins differs from that of the run that wrote it. Collective.
  Archive read(std::string const& restart, NodeSets const& here) const;

  bool isTime() const; // by the clock of this rank
  bool areDueAfter(std::int64_t num_steps) const { return num_steps % interval_ == 0; }

  // Writes what `save` puts into the archive. OutputError if the directory is gone. Collective.
  void write(std::function<void(Archive&)> const& save, NodeSets const& here);

private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path directory_;
  int interval_; // in steps
  std::chrono::duration<double, std::ratio<60>> minutes_;
  std::string plugins_; // their content
  io::Fingerprint fingerprint_;
  RCP<const Communicator> communicator_;
  Clock::time_point last_ = Clock::now();
};
} // namespace asperity::scenario
