#include "io/series/SegmentedTable.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "io/files/DurableFile.hpp"
#include "io/parallel/BlocksInOrder.hpp"

#include <algorithm>
#include <cstdlib>

namespace asperity::io
{
std::string segmentName(std::string const& name, std::size_t segment)
{
  return "segments/" + name + formatted("_%06zu.h5", segment);
}

void describe(h5::Dataset dataset, std::string const& unit, std::string const& description)
{
  dataset.setAttribute("unit", unit);
  dataset.setAttribute("description", description);
}

namespace
{
using Column = SegmentedTable::Column;

void describeColumn(h5::Dataset dataset, Column const& column)
{
  if (column.support == Column::Support::elements) {
    dataset.setAttribute("centring", "elements");
  }
  if (!column.components.empty()) {
    dataset.setAttribute("components", column.components);
  }
  describe(std::move(dataset), column.unit, column.description);
}

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
  if (options_.nodes != nullptr) {
    blocks_.emplace(*options_.nodes);
    auto const& columns = options_.columns;
    if (std::any_of(columns.begin(), columns.end(), [](Column const& column) {
          return column.support == Column::Support::elements;
        })) {
      elements_.emplace(*options_.nodes, *blocks_);
    }
  }
}

std::filesystem::path SegmentedTable::segmentPath(std::size_t segment) const
{
  return options_.directory / segmentName(options_.name, segment);
}

std::filesystem::path SegmentedTable::indexPath() const
{
  return options_.directory / (options_.name + ".h5");
}

void SegmentedTable::append(std::size_t num_rows, std::vector<std::vector<double>> const& values)
{
  ASPERITY_ASSERT(comm_->getRank() > 0 || values.size() == waiting_.size());
  rows_in_open_segment_ += static_cast<std::int64_t>(num_rows);
  rows_waiting_ += num_rows;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    if (options_.columns[i].support != Column::Support::run || comm_->getRank() == 0) {
      waiting_[i].insert(waiting_[i].end(), values[i].begin(), values[i].end());
    }
  }
  if (rows_waiting_ >= options_.rows_per_write) {
    writeRows();
  }
}

void SegmentedTable::openSegment() const
{
  const auto path = segmentPath(rows_of_segment_.size());
  detail::makeFolderOf(path);
  h5::File segment = h5::File::create(path);
  constexpr hsize_t numbers_per_chunk = 1024;
  for (auto const& column : options_.columns) {
    const hsize_t rows_per_chunk =
      column.row_shape.empty() ? numbers_per_chunk : options_.rows_per_write;
    describeColumn(
      segment.createExtendable(column.path, column.type, column.row_shape, rows_per_chunk), column);
  }
  segment.close();
}

void SegmentedTable::writeRows()
{
  if (rows_waiting_ == 0) {
    return;
  }
  std::optional<h5::File> segment; // of rank 0
  onRoot(*comm_, [&] {
    if (rows_in_open_segment_ == static_cast<std::int64_t>(rows_waiting_)) {
      openSegment(); // the first rows of the segment
    }
    segment = h5::File::openForWriting(segmentPath(rows_of_segment_.size()));
  });
  for (std::size_t i = 0; i < options_.columns.size(); ++i) {
    writeColumn(segment, i);
    waiting_[i].clear();
  }
  onRoot(*comm_, [&] { segment->close(); });
  rows_waiting_ = 0;
}

// Rank 0 writes the blocks of all ranks, one after the other.
template <class Blocks>
void SegmentedTable::writeBlocks(std::optional<h5::Dataset>& dataset, std::size_t i,
                                 Blocks const& blocks) const
{
  auto const& shape = options_.columns[i].row_shape;
  const std::size_t components = shape.size() > 1 ? shape[1] : 1;
  const std::size_t rows = rows_waiting_;
  hsize_t first = 0;
  visitInOrder<double>(blocks(waiting_[i], rows, components), *comm_,
                       [&](std::vector<double> const& block) {
                         const hsize_t count = block.size() / (rows * components);
                         if (count > 0) {
                           dataset->writeRows(block.data(), rows, {first, count});
                         }
                         first += count;
                       });
}

void SegmentedTable::writeColumn(std::optional<h5::File>& segment, std::size_t i)
{
  auto const& column = options_.columns[i];
  std::optional<h5::Dataset> dataset; // of rank 0
  onRoot(*comm_, [&] {
    dataset = segment->openDataset(column.path);
    dataset->extend(rows_waiting_);
    if (column.support == Column::Support::run) {
      const hsize_t all = column.row_shape.empty() ? 1 : column.row_shape[0];
      dataset->writeRows(waiting_[i].data(), rows_waiting_, {0, all});
    }
  });
  if (column.support == Column::Support::nodes) {
    writeBlocks(dataset, i, *blocks_);
  } else if (column.support == Column::Support::elements) {
    writeBlocks(dataset, i, *elements_);
  }
}

void SegmentedTable::closeSegment(int index)
{
  ASPERITY_ASSERT(index == static_cast<int>(rows_of_segment_.size()));
  writeRows();
  if (rows_in_open_segment_ > 0) {
    onRoot(*comm_, [&] { detail::synchronise(segmentPath(rows_of_segment_.size())); });
  }
  rows_of_segment_.push_back(rows_in_open_segment_);
  rows_in_open_segment_ = 0;
  writeGeometry();
  writeIndex();
}

void SegmentedTable::writeGeometry()
{
  if (blocks_ && !geometry_) {
    geometry_ = detail::writeGeometry(options_.directory, options_.name, *options_.nodes, *blocks_);
  }
}

void SegmentedTable::writeIndex() const
{
  std::optional<h5::File> file; // of rank 0
  onRoot(*comm_, [&] { file = createIndex(); });
  for (auto const& number : options_.nodal_numbers) {
    hsize_t first = 0;
    visitInOrder<double>(
      (*blocks_)(*number.values, 1, 1), *comm_, [&](std::vector<double> const& block) {
        if (!block.empty()) {
          file->openDataset(number.path).writePart(block.data(), {first, block.size()});
        }
        first += block.size();
      });
  }
  onRoot(*comm_, [&] {
    file->close();
    detail::replace(indexPath()); // a restart makes it anew
  });
}

h5::File SegmentedTable::createIndex() const
{
  std::vector<h5::VirtualPart> parts;
  for (std::size_t i = 0; i < rows_of_segment_.size(); ++i) {
    parts.push_back({segmentName(options_.name, i), static_cast<hsize_t>(rows_of_segment_[i])});
  }
  h5::File file = h5::File::create(detail::temporaryName(indexPath()));
  options_.describe_index(file);
  for (auto const& number : options_.nodal_numbers) {
    const h5::Shape nodes{static_cast<hsize_t>(options_.nodes->num_global_nodes)};
    describe(file.create(number.path, h5::Type::float64, nodes), number.unit, number.description);
  }
  if (geometry_) {
    file.link("geometry", geometry_->name);
  }
  for (auto const& column : options_.columns) {
    describeColumn(file.createVirtual(column.path, column.type, column.row_shape, parts), column);
  }
  return file;
}

void SegmentedTable::save(Archive& archive) const
{
  ASPERITY_ASSERT(rows_in_open_segment_ == 0);
  archive.set("rows_of_segment", rows_of_segment_);
}

void SegmentedTable::restore(Archive const& archive)
{
  rows_of_segment_ = archive.get<std::vector<std::int64_t>>("rows_of_segment");
  onRoot(*comm_, [&] { removeLaterSegments(); });
  writeGeometry();
  writeIndex();
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
} // namespace asperity::io
