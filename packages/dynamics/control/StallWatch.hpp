#pragma once

#include <cstdint>
#include <string>

namespace asperity::dynamics
{
// Reports that a run hardly advances, because all its steps have the smallest size.
class StallWatch
{
public:
  // most_forced: the number of forced steps in a row at which the run ends; 0 means no limit.
  explicit StallWatch(std::int64_t most_forced) : most_forced_(most_forced) {}

  struct Step
  {
    bool is_smallest = false;
    bool is_forced = false; // accepted above the tolerance
    double time = 0;        // [s]
    double step_size = 0;   // [s]
    double time_left = 0;   // to the end of the run [s]
  };
  // A sentence for the log, or "" for most steps. Throws SolveError at the limit most_forced.
  std::string note(Step const& step);

  // What a restart goes on from: steps in a row.
  struct Memory
  {
    std::int64_t smallest = 0, forced = 0;
  };
  Memory const& memory() const { return memory_; }
  void restore(Memory const& memory) { memory_ = memory; }

private:
  std::int64_t most_forced_;
  Memory memory_;
};
} // namespace asperity::dynamics
