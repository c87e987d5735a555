#pragma once

#include "catalogue/events/Event.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// The columns of events.csv but for the energies, "number,onset [s],...".
std::string eventColumns(bool on_surface);

// "events_<boundary>.csv" for each boundary, all different: letters, digits, '.', '-' and '_' of a
// name stay, others become '_', and one more follows where a name is taken.
std::vector<std::string> eventFiles(std::vector<std::string> const& boundaries);

// A row of them, without an end of line.
std::string eventRow(Event const& event);

// An event as numbers, for a checkpoint; `dimension` is that of space.
void appendNumbers(Event const& event, std::size_t dimension, std::vector<double>& numbers);
std::size_t numbersOfEvent(std::size_t dimension);
Event eventFrom(double const* numbers, std::size_t dimension);
} // namespace asperity::catalogue
