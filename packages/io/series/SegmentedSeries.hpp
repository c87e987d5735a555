#pragma once

#include "base/Archive.hpp"
#include "io/FieldRegistry.hpp"
#include "io/Output.hpp"
#include "io/OutputDomain.hpp"
#include "io/series/SegmentedTable.hpp"
#include "io/series/SeriesLayout.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity::io
{
// Fields of one domain over time, in closed segments tied together by the index DIR/<name>.h5 and
// by DIR/<name>.xdmf. README.md has the layout.
//
// Rows are kept in memory, then written by rank 0. Until closeSegment they may be lost; closed
// segments stay complete whatever happens. All functions are collective.
class SegmentedSeries
{
public:
  struct Options
  {
    std::filesystem::path directory;
    std::string name; // of the index, "fault"
    bool single_precision = false;
    int rows_per_write = 64; // fewer where rows are long
  };

  // The domain and the fields must outlive the series.
  SegmentedSeries(Options const& options, OutputDomain const& domain,
                  std::vector<OutputField const*> const& fields);
  SegmentedSeries(SegmentedSeries const&) = delete;
  SegmentedSeries& operator=(SegmentedSeries const&) = delete;

  // Adds a row with the present values of the fields.
  void append(StepInfo const& step);

  // Completes the segment `index`, one more than that of the last call, and writes the index anew.
  // A segment without rows has no file.
  void closeSegment(int index);

  // Save and restore everything up to the last closed segment. restore removes later segments; it
  // throws InputError if an earlier one is missing.
  void save(Archive& archive) const;
  void restore(Archive const& archive);

private:
  OutputDomain const& domain_;
  std::vector<OutputField const*> fields_;
  SeriesLayout layout_;
  SegmentedTable table_;
  std::vector<double> times_; // of all rows [s]
};
} // namespace asperity::io
