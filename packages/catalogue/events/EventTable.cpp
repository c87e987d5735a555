#include "catalogue/events/EventTable.hpp"

#include "io/files/TextTable.hpp"

#include <algorithm>
#include <cctype>

namespace asperity::catalogue
{
namespace
{
constexpr std::size_t numbers_without_place = 11;
} // namespace

std::string eventColumns(bool on_surface)
{
  const std::string times = "number,onset [s],end [s],duration [s],";
  if (on_surface) {
    return times + "area [m^2],length [m],width [m],peak_slip [m],peak_slip_rate [m/s],"
                   "moment [N m],magnitude,hypocentre_x [m],hypocentre_y [m],hypocentre_z [m],"
                   "complete";
  }
  return times + "width [m],peak_slip [m],peak_slip_rate [m/s],moment_per_length [N],"
                 "nucleation_from_upper_end [m],complete";
}

std::vector<std::string> eventFiles(std::vector<std::string> const& boundaries)
{
  std::vector<std::string> files;
  for (std::string name : boundaries) {
    for (char& letter : name) {
      const bool is_safe =
        std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '.' || letter == '-';
      letter = is_safe ? letter : '_';
    }
    std::string file = "events_" + name;
    while (std::find(files.begin(), files.end(), file + ".csv") != files.end()) {
      file += '_';
    }
    files.push_back(file + ".csv");
  }
  return files;
}

std::string eventRow(Event const& event)
{
  std::string row = std::to_string(event.number);
  for (const double time : {event.onset, event.end}) {
    row += ',' + io::exactNumber(time);
  }
  std::vector<double> values{event.duration()};
  if (event.isOnSurface()) {
    values.insert(values.end(), {event.area, event.length, event.width, event.peak_slip,
                                 event.peak_slip_rate, event.moment, event.magnitude()});
    values.insert(values.end(), event.hypocentre.begin(), event.hypocentre.end());
  } else {
    values.insert(values.end(), {event.width, event.peak_slip, event.peak_slip_rate, event.moment,
                                 event.nucleation});
  }
  for (const double value : values) {
    row += ',' + io::shortNumber(value);
  }
  return row + (event.complete ? ",1" : ",0");
}

void appendNumbers(Event const& event, std::size_t dimension, std::vector<double>& numbers)
{
  numbers.insert(numbers.end(),
                 {event.onset, event.end, event.width, event.peak_slip, event.peak_slip_rate,
                  event.moment, event.nucleation, event.complete ? 1.0 : 0.0, event.area,
                  event.length, static_cast<double>(event.number)});
  auto hypocentre = event.hypocentre;
  hypocentre.resize(dimension, 0);
  numbers.insert(numbers.end(), hypocentre.begin(), hypocentre.end());
}

std::size_t numbersOfEvent(std::size_t dimension) { return numbers_without_place + dimension; }

Event eventFrom(double const* numbers, std::size_t dimension)
{
  double const* hypocentre = numbers + numbers_without_place;
  Event event;
  event.onset = numbers[0];
  event.end = numbers[1];
  event.width = numbers[2];
  event.peak_slip = numbers[3];
  event.peak_slip_rate = numbers[4];
  event.moment = numbers[5];
  event.nucleation = numbers[6];
  event.complete = numbers[7] != 0;
  event.area = numbers[8];
  event.length = numbers[9];
  event.number = static_cast<std::int64_t>(numbers[10]);
  event.hypocentre = {hypocentre, hypocentre + dimension};
  return event;
}
} // namespace asperity::catalogue
