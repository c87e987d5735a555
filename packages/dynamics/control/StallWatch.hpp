#pragma once

#include <cstdint>
#include <string>

namespace asperity::dynamics
{
// Notices while a run goes on that it does not get ahead: its steps have the smallest size, one
// after the other.
class StallWatch
{
public:
  // most_forced: steps in a row above the tolerance that are one too many; 0 means any number.
  explicit StallWatch(std::int64_t most_forced) : most_forced_(most_forced) {}

  struct Step
  {
    bool is_smallest = false;
    bool is_forced = false; // accepted above the tolerance
    double time = 0;        // [s]
    double step_size = 0;   // [s]
    double time_left = 0;   // to the end of the run [s]
  };
  // A sentence for the log, or "" for most steps. Throws SolveError for one forced step too many.
  std::string note(Step const& step);

private:
  std::int64_t most_forced_;
  std::int64_t smallest_ = 0, forced_ = 0; // in a row
};
} // namespace asperity::dynamics
