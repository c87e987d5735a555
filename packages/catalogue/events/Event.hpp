#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// A time in which some node slides at least as fast as the threshold: contiguous, or with pauses
// shorter than the catalogue's merging time. On a fault that is a curve the moment is per metre of
// the third dimension, and there is neither area nor length.
struct Event
{
  double onset = 0;          // [s]
  double end = 0;            // [s]; the last accepted step if not complete
  double width = 0;          // [m] between the first and the last node that reached the threshold:
                             // along the curve, on a surface down dip in its mean plane
  double peak_slip = 0;      // [m] largest slip of a node while it was at seismic rates
  double peak_slip_rate = 0; // [m/s]
  double moment = 0;         // [N m], or [N m/m]
  double nucleation = 0;     // [m] position of the first node above the threshold, on a curve:
                             // from its upper end
  std::string fault;         // where it began, if a curve has several; not stored
  bool complete = true;      // false if it was in progress when the run ended

  // The number of its first part among all events of the run, from 1, as in rupture.h5; of one of
  // several faults that of the event in which it takes part.
  std::int64_t number = 0;

  double area = 0;                // [m^2] of the nodes that reached the threshold
  double length = 0;              // [m] as width, along strike
  std::vector<double> hypocentre; // (dimension) [m] of the first node above the threshold

  double duration() const { return end - onset; }
  bool isOnSurface() const { return hypocentre.size() == 3; }

  // Mw = 2/3 (log10(M0 / (N m)) - 9.1), on a surface; -inf without moment.
  double magnitude() const;
};

struct Quartiles
{
  double lower = 0, median = 0, upper = 0; // nan if there are no values
};

struct EventSummary
{
  std::int64_t num_events = 0; // all; the quartiles after recurrence are of the complete ones
  bool is_on_surface = false;
  Quartiles recurrence;     // [s] onset to onset
  Quartiles width;          // [m]
  Quartiles area;           // [m^2], on a surface
  Quartiles magnitude;      // [-], on a surface
  Quartiles peak_slip;      // [m]
  Quartiles duration;       // [s]
  Quartiles peak_slip_rate; // [m/s]
};

EventSummary summarise(std::vector<Event> const& events);

// An aligned table; the first and the last 15 rows if there are more than 30 events.
void printEvents(std::ostream& out, std::vector<Event> const& events);
void printSummary(std::ostream& out, EventSummary const& summary);
} // namespace asperity::catalogue
