#pragma once

#include "io/Output.hpp"
#include "io/files/TextTable.hpp"
#include "io/platforms/TextFormat.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace asperity::io::detail
{
// What the header of a time series says about the steps or, on a platform that wants rows at
// equal distances, about the rows.
struct StepFacts
{
  double shortest = std::numeric_limits<double>::infinity(); // [s]
  double longest = 0;                                        // [s]
  std::int64_t count = 0;

  void add(StepInfo const& step); // the initial state is no step
  void save(Archive& archive) const;
  void restore(Archive const& archive);
};

// What is particular to one file.
struct PlatformContent
{
  std::string name;                 // "fltst_dp075"
  std::string location;             // "on fault, ..."; empty: not a station
  std::vector<std::string> remarks; // one line each: what the columns are
  std::string fields;               // the line, or lines, after the comments
};

// The header, without the end of its last line; its length does not depend on the facts. Without
// facts it is that of a file without time series.
std::string platformHeader(TextFormat const& format, PlatformContent const& content,
                           StepFacts const* facts);

// "# Column #1 = Time (s)" and the like, without "# ".
std::vector<std::string> columnRemarks(std::vector<std::string> const& columns);

// Numbers as the platforms have them: times with 15 digits, others with 7.
std::string platformTime(double value);   // %21.14E
std::string platformNumber(double value); // %14.6E

// What has no logarithm, such as the slip rate of a fault at rest, has this one.
inline constexpr double smallest_logarithm = -99;
double platformLogarithm(double value); // decimal

// A time series as a platform takes it: DIR/seas/<name> or DIR/scec/<name>, written by rank 0.
class PlatformSeries
{
public:
  PlatformSeries(TextFormat const& format, std::filesystem::path const& directory,
                 PlatformContent const& content, RCP<const Communicator> const& comm);

  // On rank 0; ignored elsewhere.
  void writeRow(double time, double const* values, std::size_t number);

  // On disk afterwards, with these facts in the header. Collective.
  void flush(StepFacts const& facts);

  void save(Archive& archive) const { table_.save(archive); }
  void restore(Archive const& archive) { table_.restore(archive); }

private:
  TextFormat format_;
  PlatformContent content_;
  TextTable table_;
};
} // namespace asperity::io::detail
