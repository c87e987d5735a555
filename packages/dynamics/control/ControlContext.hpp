#pragma once

#include "dynamics/DyadicTime.hpp"
#include "dynamics/coupling/CoupledStep.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::dynamics
{
// What a step control works with in addition to its parameters.
struct ControlContext
{
  CoupledStep& step;
  int order = 2;         // of convergence of the scheme
  std::string path = ""; // of the deck's list `Time Stepping`, for messages
  double wave_rate = 0;  // WaveScale::slip_rate [m/s]

  std::vector<DyadicTime::Ticks> instants = {};      // which no step passes, ascending
  RCP<const Vector> displacement = Teuchos::null;    // at the start of the run [m]; null: zero
  double least_displacement = 0, least_velocity = 0; // below which no error matters [m, m/s]
  // What messages say about the place of a local vertex, "node 17, (0, 1)"; may be empty.
  std::function<std::string(int)> place_of = {};
};
} // namespace asperity::dynamics
