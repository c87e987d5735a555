#pragma once

#include "surfaces/Lofting.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// Points of a trace in the file's units, and what stands behind them.
struct TraceFile
{
  Polyline points;
  std::vector<double> dips; // [degrees], empty if the file has none
};

// Lines with the columns that the words name, "x y", "x y dip", "x y z" or "x y z dip"; # begins a
// comment, and a line > may stand before the first point. InputError with file and line.
TraceFile readTrace(std::string const& file_name, std::string const& columns);
std::vector<std::string> traceColumns();
} // namespace asperity::geometry
