#pragma once

#include "io/Archive.hpp"
#include "io/FieldRegistry.hpp"
#include "io/H5.hpp"
#include "io/Location.hpp"
#include "io/Output.hpp"
#include "io/detail/NodeGather.hpp"
#include "io/detail/SeriesIndex.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::io
{
// Fields of one location over time, in closed segments DIR/segments/<name>_<nnnnnn>.h5 tied
// together by the index DIR/<name>.h5 (virtual datasets) and DIR/<name>.xdmf. README.md has the
// layout.
//
// Rows are kept in memory, then collected on rank 0, which writes. Until closeSegment they may be
// lost; what was closed before stays whole whatever happens. All functions are collective.
class SegmentedSeries
{
public:
  struct Options
  {
    std::filesystem::path directory;
    std::string name;              // of the index, "fault"
    bool single_precision = false;
    int rows_per_write = 64;       // fewer where rows are long
  };

  // Location and fields must outlive the series.
  SegmentedSeries(Options const& options, Location const& location,
                  std::vector<Field const*> const& fields);

  // Adds a row with the fields' values of this moment.
  void append(StepInfo const& step);

  // Completes the segment `index`, one more than that of the last call, and writes the index anew.
  // A segment without rows has no file.
  void closeSegment(int index);

  // Everything up to the last closed segment. restore removes later segments.
  void save(Archive& archive) const;
  void restore(Archive const& archive);

private:
  void writeRows();
  void openSegment();
  void removeLaterSegments() const; // InputError if an earlier one is missing

  Location const& location_;
  std::vector<Field const*> fields_;
  detail::SeriesLayout layout_;
  detail::NodeGather gather_;
  detail::WholeGeometry geometry_;
  std::size_t rows_per_write_;

  std::vector<std::int64_t> rows_of_segment_; // closed ones
  std::vector<double> times_;                 // of all rows [s]
  std::int64_t rows_in_open_segment_ = 0;     // written or waiting

  struct Waiting
  {
    std::vector<double> times;
    std::vector<std::int64_t> steps;
    std::vector<std::vector<double>> values; // by field: (rows, num_owned, components)
  };
  Waiting waiting_;
  std::optional<h5::File> segment_; // rank 0, between the first rows written and closeSegment
};
} // namespace asperity::io
