#pragma once

#include "parameters/Entries.hpp"

namespace asperity::catalogue
{
// What the deck's list `Event Catalogue` says.
struct EventSettings
{
  static constexpr double no_magnitude = -99;

  bool is_enabled = true;
  double threshold = 1e-3;                  // [m/s]
  double merging_time = 0;                  // [s]
  double smallest_width = 0;                // [m]
  double smallest_magnitude = no_magnitude; // of a surface
  int most_events = 0;                      // with which the run ends; 0 for any number
  bool each_fault = false;

  static Entries<EventSettings> entries();
};
} // namespace asperity::catalogue
