#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

namespace asperity::io
{
// One contiguous time in which some node slides at least as fast as the threshold.
struct Event
{
  double onset = 0;          // [s]
  double end = 0;            // [s]; the last accepted step if not complete
  double width = 0;          // [m] from the first to the last node that reached the threshold
  double peak_slip = 0;      // [m] largest slip of a node while it was at seismic rates
  double peak_slip_rate = 0; // [m/s]
  double moment = 0;         // [N m/m] per metre of the third dimension
  double nucleation = 0;     // [m] position of the first node above the threshold
  bool complete = true;      // false if it was in progress when the run ended

  double duration() const { return end - onset; }
};

struct Quartiles
{
  double lower = 0, median = 0, upper = 0; // nan if there is nothing to take them of
};

struct EventSummary
{
  std::int64_t num_events = 0; // all; the quartiles after recurrence are of the complete ones
  Quartiles recurrence;        // [s] onset to onset
  Quartiles width;             // [m]
  Quartiles peak_slip;         // [m]
  Quartiles duration;          // [s]
  Quartiles peak_slip_rate;    // [m/s]
};

EventSummary summarise(std::vector<Event> const& events);

// An aligned table; the first and the last 15 rows if there are more than 30 events.
void printEvents(std::ostream& out, std::vector<Event> const& events);
void printSummary(std::ostream& out, EventSummary const& summary);
} // namespace asperity::io
