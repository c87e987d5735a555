#pragma once

#include "io/files/TimeLeft.hpp"

#include <cstdint>
#include <optional>

namespace asperity::io
{
// How far a run has come.
struct Progress
{
  double time = 0;           // simulated [s]
  double final_time = 0;     // [s]
  double step_size = 0;      // [s]
  double peak_slip_rate = 0; // [m/s]
  std::int64_t step = 0;
  int fixed_point_iterations = 0;
  std::optional<std::int64_t> num_events; // Output::numEvents, if an output counts them
  double wall_time = 0;                   // [s]
  std::optional<TimeLeft::Estimate> left;
};
} // namespace asperity::io
