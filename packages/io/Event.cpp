#include "io/Event.hpp"

#include "base/Text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

namespace asperity::io
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

Row describe(std::size_t number, Event const& event)
{
  return {std::to_string(number),           formatShort(event.onset),
          formatShort(event.duration()),    formatShort(event.width),
          formatShort(event.peak_slip),     formatShort(event.peak_slip_rate),
          formatShort(event.nucleation),    event.complete ? "" : "in progress"};
}

Row describe(std::string const& name, Quartiles const& values)
{
  return {name, formatShort(values.lower), formatShort(values.median), formatShort(values.upper)};
}
} // namespace

EventSummary summarise(std::vector<Event> const& events)
{
  std::vector<double> recurrence, width, peak_slip, duration, peak_slip_rate;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (i > 0) {
      recurrence.push_back(events[i].onset - events[i - 1].onset);
    }
    if (events[i].complete) {
      width.push_back(events[i].width);
      peak_slip.push_back(events[i].peak_slip);
      duration.push_back(events[i].duration());
      peak_slip_rate.push_back(events[i].peak_slip_rate);
    }
  }
  EventSummary summary;
  summary.num_events = static_cast<std::int64_t>(events.size());
  summary.recurrence = quartiles(recurrence);
  summary.width = quartiles(width);
  summary.peak_slip = quartiles(peak_slip);
  summary.duration = quartiles(duration);
  summary.peak_slip_rate = quartiles(peak_slip_rate);
  return summary;
}

void printEvents(std::ostream& out, std::vector<Event> const& events)
{
  constexpr std::size_t most_rows = 30;
  std::vector<Row> rows{{"event", "onset [s]", "duration [s]", "width [m]", "peak slip [m]",
                         "peak rate [m/s]", "nucleation [m]"}};
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool is_shown = events.size() <= most_rows || i < most_rows / 2 ||
                          i + most_rows / 2 >= events.size();
    if (is_shown) {
      rows.push_back(describe(i + 1, events[i]));
    } else if (i == most_rows / 2) {
      rows.push_back({"..."});
    }
  }
  printAligned(out, rows);
}

void printSummary(std::ostream& out, EventSummary const& summary)
{
  out << summary.num_events << (summary.num_events == 1 ? " event" : " events") << '\n';
  if (summary.num_events > 0) {
    printAligned(out, {{"quartiles", "25 %", "50 %", "75 %"},
                       describe("recurrence [s]", summary.recurrence),
                       describe("width [m]", summary.width),
                       describe("peak slip [m]", summary.peak_slip),
                       describe("duration [s]", summary.duration),
                       describe("peak rate [m/s]", summary.peak_slip_rate)});
  }
}
} // namespace asperity::io
