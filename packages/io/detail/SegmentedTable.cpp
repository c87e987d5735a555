#include "io/detail/SegmentedTable.hpp"

#include "base/Errors.hpp"
#include "io/detail/DurableFile.hpp"
#include "io/detail/Gather.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace asperity::io::detail
{
std::string segmentName(std::string const& name, std::size_t segment)
{
  char number[24];
  std::snprintf(number, sizeof number, "%06zu", segment);
  return "segments/" + name + "_" + number + ".h5";
}

void describe(h5::Dataset dataset, std::string const& unit, std::string const& description)
{
  dataset.setAttribute("unit", unit);
  dataset.setAttribute("description", description);
}

namespace
{
// The numbers of the segments of this name on disk.
std::vector<std::size_t> segmentsOnDisk(std::filesystem::path const& directory,
                                        std::string const& name)
{
  std::vector<std::size_t> segments;
  const auto folder = directory / "segments";
  if (!std::filesystem::is_directory(folder)) {
    return segments;
  }
  for (auto const& entry : std::filesystem::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    const std::size_t digits = stem.find_last_of('_') + 1;
    const std::size_t segment = std::strtoul(stem.c_str() + digits, nullptr, 10);
    if ("segments/" + entry.path().filename().string() == segmentName(name, segment)) {
      segments.push_back(segment);
    }
  }
  return segments;
}
} // namespace

SegmentedTable::SegmentedTable(Options options, RCP<const Communicator> comm)
    : options_(std::move(options))
    , comm_(std::move(comm))
    , waiting_(options_.columns.size())
{
}

std::filesystem::path SegmentedTable::segmentPath(std::size_t segment) const
{
  return options_.directory / segmentName(options_.name, segment);
}

void SegmentedTable::append(std::size_t num_rows, std::vector<std::vector<double>> const& values)
{
  rows_in_open_segment_ += static_cast<std::int64_t>(num_rows);
  rows_waiting_ += num_rows;
  if (comm_->getRank() == 0) {
    ASPERITY_ASSERT(values.size() == waiting_.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      waiting_[i].insert(waiting_[i].end(), values[i].begin(), values[i].end());
    }
  }
  if (rows_waiting_ >= options_.rows_per_write) {
    writeRows();
  }
}

void SegmentedTable::openSegment()
{
  const auto path = segmentPath(rows_of_segment_.size());
  std::filesystem::create_directories(path.parent_path());
  segment_ = h5::File::create(path);
  constexpr hsize_t numbers_per_chunk = 1024;
  for (auto const& column : options_.columns) {
    const hsize_t rows_per_chunk =
      column.row_shape.empty() ? numbers_per_chunk : options_.rows_per_write;
    describe(segment_->createExtendable(column.path, column.type, column.row_shape, rows_per_chunk),
             column.unit, column.description);
  }
}

void SegmentedTable::writeRows()
{
  if (rows_waiting_ == 0) {
    return;
  }
  onRoot(*comm_, [&] {
    if (!segment_) {
      openSegment();
    }
    for (std::size_t i = 0; i < options_.columns.size(); ++i) {
      segment_->openDataset(options_.columns[i].path).append(waiting_[i].data(), rows_waiting_);
      waiting_[i].clear();
    }
  });
  rows_waiting_ = 0;
}

void SegmentedTable::closeSegment(int index)
{
  ASPERITY_ASSERT(index == static_cast<int>(rows_of_segment_.size()));
  writeRows();
  onRoot(*comm_, [&] {
    if (segment_) {
      segment_->close();
      segment_.reset();
      synchronise(segmentPath(rows_of_segment_.size()));
    }
  });
  rows_of_segment_.push_back(rows_in_open_segment_);
  rows_in_open_segment_ = 0;
  onRoot(*comm_, [&] { writeIndex(); });
}

void SegmentedTable::writeIndex() const
{
  std::vector<h5::VirtualPart> parts;
  for (std::size_t i = 0; i < rows_of_segment_.size(); ++i) {
    parts.push_back({segmentName(options_.name, i), static_cast<hsize_t>(rows_of_segment_[i])});
  }
  const auto path = options_.directory / (options_.name + ".h5");
  h5::File file = h5::File::create(temporaryName(path));
  options_.describe_index(file);
  for (auto const& column : options_.columns) {
    describe(file.createVirtual(column.path, column.type, column.row_shape, parts), column.unit,
             column.description);
  }
  file.close();
  replace(path); // a restart makes it anew
}

void SegmentedTable::save(Archive& archive) const
{
  ASPERITY_ASSERT(rows_in_open_segment_ == 0);
  archive.set("rows_of_segment", rows_of_segment_);
}

void SegmentedTable::restore(Archive const& archive)
{
  rows_of_segment_ = archive.get<std::vector<std::int64_t>>("rows_of_segment");
  onRoot(*comm_, [&] {
    removeLaterSegments();
    writeIndex();
  });
}

void SegmentedTable::removeLaterSegments() const
{
  for (std::size_t i = 0; i < rows_of_segment_.size(); ++i) {
    ASPERITY_REQUIRE(rows_of_segment_[i] == 0 || std::filesystem::exists(segmentPath(i)),
                     segmentPath(i).string()
                       << " is missing, but the checkpoint continues it. Restart in the "
                          "directory of the earlier run.");
  }
  for (const std::size_t segment : segmentsOnDisk(options_.directory, options_.name)) {
    if (segment >= rows_of_segment_.size()) {
      std::filesystem::remove(segmentPath(segment));
    }
  }
}
} // namespace asperity::io::detail
