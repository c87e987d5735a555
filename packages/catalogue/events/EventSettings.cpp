#include "catalogue/events/EventSettings.hpp"

namespace asperity::catalogue
{
Entries<EventSettings> EventSettings::entries()
{
  using S = EventSettings;
  return Entries<S>()
    .boolean("Enabled", &S::is_enabled, "If true, the run writes this output.")
    .real("Threshold", &S::threshold, "m/s", Range::positive(),
          "A node is seismic while its slip rate is at least this. An event lasts as long as some "
          "node is seismic.")
    .real("Merging Time", &S::merging_time, "s", Range::atLeast(0),
          "Two events are one if less than this passes from the end of one to the onset of the "
          "next.")
    .real("Smallest Width", &S::smallest_width, "m", Range::atLeast(0),
          "Events of a smaller width are left out of the table; the other events keep their "
          "numbers.")
    .real("Smallest Magnitude", &S::smallest_magnitude, "-", Range::atLeast(no_magnitude),
          "Events of a smaller moment magnitude are left out of the table, in three dimensions; "
          "-99 leaves out none.")
    .integer(
      "Most Events", &S::most_events, Range::atLeast(0),
      "The run ends before its final time when the table has this number of events; 0 means no "
      "limit. With a larger number --restart continues a run that ended so.")
    .boolean("Each Fault", &S::each_fault,
             "If true, each of several faults also has a table, events_<boundary>.csv, of the "
             "times in which some node of this fault is seismic.");
}
} // namespace asperity::catalogue
