#pragma once

#include "io/Output.hpp"
#include "io/files/TextTable.hpp"
#include "platforms/RunFacts.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace asperity::platforms
{
// What the header of a time series says about the steps or, on a platform that wants rows at
// equal distances, about the rows.
struct StepFacts
{
  double shortest = std::numeric_limits<double>::infinity(); // [s]
  double longest = 0;                                        // [s]
  std::int64_t count = 0;

  void add(io::StepInfo const& step); // the initial state is no step
  void save(io::Archive& archive) const;
  void restore(io::Archive const& archive);
};

// What all files of a platform have in common.
struct Platform
{
  std::string name;             // in the deck, "SEAS"
  std::filesystem::path folder; // of its files, in that of the run: "seas"
  RunFacts run;
  // Lines of the header of a time series, of the same length for any facts.
  std::function<std::vector<std::string>(StepFacts const&)> step_lines;
};

// What is particular to one file.
struct FileContent
{
  std::string name;                 // "fltst_dp075"
  std::string place;                // "on fault, ..."; empty: not a station
  std::vector<std::string> remarks; // one line each: what the columns are
  std::string fields;               // the line, or lines, after the comments
};

// The header, without the end of its last line; its length does not depend on the facts. Without
// facts it is that of a file without time series.
std::string fileHeader(Platform const& platform, FileContent const& content,
                       StepFacts const* facts);

// "# Column #1 = Time (s)" and the like, without "# ".
std::vector<std::string> columnRemarks(std::vector<std::string> const& columns);

// Numbers as the platforms have them: times with 15 digits, others with 7.
std::string timeText(double value);   // %21.14E
std::string numberText(double value); // %14.6E

// "minimum_time_step=3.000000E-02" and "num_time_steps=12034       ".
std::string stepSizeLine(std::string const& name, double value);
std::string countLine(std::int64_t count);

// The logarithm that is written for values <= 0, such as the slip rate of a fault at rest.
inline constexpr double smallest_logarithm = -99;
double decimalLogarithm(double value);

// A time series as a platform takes it: DIR/<folder>/<name>, written by rank 0.
class TimeSeries
{
public:
  TimeSeries(Platform const& platform, FileContent const& content,
             io::OutputContext const& context);

  // On rank 0; ignored elsewhere.
  void writeRow(double time, double const* values, std::size_t number);

  // Writes everything to disk, with these facts in the header. Collective.
  void flush(StepFacts const& facts);

  void save(io::Archive& archive) const { table_.save(archive); }
  void restore(io::Archive const& archive) { table_.restore(archive); }

private:
  Platform platform_;
  FileContent content_;
  io::TextTable table_;
};
} // namespace asperity::platforms
