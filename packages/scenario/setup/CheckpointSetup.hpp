#pragma once

#include "parameters/Parameters.hpp"

namespace asperity::scenario
{
// When checkpoints are written, by the deck's list `Output`.
struct CheckpointIntervals
{
  int num_steps = 5000;
  double minutes = 60; // of wall time

  static void declare(ParameterList& output);
  static CheckpointIntervals from(ParameterList const& output);
};
} // namespace asperity::scenario
