#include "catalogue/events/Event.hpp"

#include "base/Text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

namespace asperity::catalogue
{
namespace
{
// Linear interpolation between the sorted values, as numpy.quantile does by default.
double quantile(std::vector<double> const& sorted, double fraction)
{
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Quartiles quartiles(std::vector<double> values)
{
  if (values.empty()) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
  }
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

using Row = std::vector<std::string>;

// Right-aligned columns, two blanks between them.
void printAligned(std::ostream& out, std::vector<Row> const& rows)
{
  std::vector<std::size_t> widths;
  for (auto const& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  for (auto const& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      out << (i > 0 ? "  " : "") << std::string(widths[i] - row[i].size(), ' ') << row[i];
    }
    out << '\n';
  }
}

Row titles(bool on_surface)
{
  if (on_surface) {
    return {"event", "onset [s]",     "duration [s]",    "area [m^2]",
            "Mw",    "peak slip [m]", "peak rate [m/s]", "hypocentre [m]"};
  }
  return {"event",
          "onset [s]",
          "duration [s]",
          "width [m]",
          "peak slip [m]",
          "peak rate [m/s]",
          "nucleation from upper end [m]"};
}

std::string placeOf(Event const& event)
{
  return event.isOnSurface()
           ? formatPoint(event.hypocentre)
           : formatShort(event.nucleation) + (event.fault.empty() ? "" : " (" + event.fault + ')');
}

Row describe(Event const& event)
{
  Row row{std::to_string(event.number), formatShort(event.onset), formatShort(event.duration())};
  if (event.isOnSurface()) {
    row.insert(row.end(), {formatShort(event.area), formatShort(event.magnitude())});
  } else {
    row.push_back(formatShort(event.width));
  }
  row.insert(row.end(), {formatShort(event.peak_slip), formatShort(event.peak_slip_rate),
                         placeOf(event), event.complete ? "" : "in progress"});
  return row;
}

Row describe(std::string const& name, Quartiles const& values)
{
  return {name, formatShort(values.lower), formatShort(values.median), formatShort(values.upper)};
}
} // namespace

double Event::magnitude() const { return 2.0 / 3.0 * (std::log10(moment) - 9.1); }

EventSummary summarise(std::vector<Event> const& events)
{
  const auto quartilesOf = [&](auto const& value) {
    std::vector<double> values;
    for (auto const& event : events) {
      if (event.complete) {
        values.push_back(value(event));
      }
    }
    return quartiles(values);
  };
  std::vector<double> recurrence;
  for (std::size_t i = 1; i < events.size(); ++i) {
    recurrence.push_back(events[i].onset - events[i - 1].onset);
  }
  EventSummary summary;
  summary.num_events = static_cast<std::int64_t>(events.size());
  summary.is_on_surface = !events.empty() && events[0].isOnSurface();
  summary.recurrence = quartiles(recurrence);
  summary.width = quartilesOf([](Event const& event) { return event.width; });
  summary.area = quartilesOf([](Event const& event) { return event.area; });
  summary.magnitude = quartilesOf([](Event const& event) { return event.magnitude(); });
  summary.peak_slip = quartilesOf([](Event const& event) { return event.peak_slip; });
  summary.duration = quartilesOf([](Event const& event) { return event.duration(); });
  summary.peak_slip_rate = quartilesOf([](Event const& event) { return event.peak_slip_rate; });
  return summary;
}

void printEvents(std::ostream& out, std::vector<Event> const& events)
{
  constexpr std::size_t most_rows = 30;
  std::vector<Row> rows{titles(!events.empty() && events[0].isOnSurface())};
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool is_shown =
      events.size() <= most_rows || i < most_rows / 2 || i + most_rows / 2 >= events.size();
    if (is_shown) {
      rows.push_back(describe(events[i]));
    } else if (i == most_rows / 2) {
      rows.push_back({"..."});
    }
  }
  printAligned(out, rows);
}

void printSummary(std::ostream& out, EventSummary const& summary)
{
  out << summary.num_events << (summary.num_events == 1 ? " event" : " events") << '\n';
  if (summary.num_events == 0) {
    return;
  }
  std::vector<Row> rows{{"quartiles", "25 %", "50 %", "75 %"}};
  const auto add = [&rows](char const* name, Quartiles const& values) {
    if (!std::isnan(values.median)) { // a single event has no recurrence
      rows.push_back(describe(name, values));
    }
  };
  add("recurrence [s]", summary.recurrence);
  if (summary.is_on_surface) {
    add("area [m^2]", summary.area);
    add("Mw", summary.magnitude);
  } else {
    add("width [m]", summary.width);
  }
  add("peak slip [m]", summary.peak_slip);
  add("duration [s]", summary.duration);
  add("peak rate [m/s]", summary.peak_slip_rate);
  if (rows.size() > 1) {
    printAligned(out, rows);
  }
}
} // namespace asperity::catalogue
