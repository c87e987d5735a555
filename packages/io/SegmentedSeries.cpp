#include "io/SegmentedSeries.hpp"

#include "base/Errors.hpp"
#include "io/detail/DurableFile.hpp"
#include "io/detail/Gather.hpp"
#include "io/detail/Xdmf.hpp"

#include <algorithm>

namespace asperity::io
{
namespace
{
detail::SeriesLayout makeLayout(SegmentedSeries::Options const& options, Location const& location,
                                std::vector<Field const*> const& fields)
{
  detail::SeriesLayout layout;
  layout.directory = options.directory;
  layout.name = options.name;
  layout.location = location.name;
  layout.type = options.single_precision ? h5::Type::float32 : h5::Type::float64;
  layout.num_nodes = static_cast<hsize_t>(location.num_global_nodes);
  layout.dimension = location.dimension;
  layout.nodes_per_element = location.nodes_per_element;
  for (Field const* field : fields) {
    layout.fields.push_back(*field);
  }
  return layout;
}

// Chunks of at most 1 MiB, so that long rows neither fill the memory nor slow down reading.
std::size_t rowsPerWrite(SegmentedSeries::Options const& options,
                         detail::SeriesLayout const& layout)
{
  constexpr std::size_t largest_chunk = 1 << 20;
  std::size_t longest_row = 1;
  for (auto const& field : layout.fields) {
    longest_row = std::max<std::size_t>(longest_row, 8 * layout.num_nodes * field.components);
  }
  return std::clamp<std::size_t>(largest_chunk / longest_row, 1, options.rows_per_write);
}
} // namespace

SegmentedSeries::SegmentedSeries(Options const& options, Location const& location,
                                 std::vector<Field const*> const& fields)
  : location_(location), fields_(fields), layout_(makeLayout(options, location, fields)),
    gather_(location), geometry_(detail::gatherGeometry(location, gather_)),
    rows_per_write_(rowsPerWrite(options, layout_))
{
  waiting_.values.resize(fields_.size());
}

void SegmentedSeries::append(StepInfo const& step)
{
  waiting_.times.push_back(step.time);
  waiting_.steps.push_back(step.step);
  times_.push_back(step.time);
  std::vector<double> values;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    fields_[i]->values(values);
    ASPERITY_ASSERT(values.size() == location_.numOwned() * fields_[i]->components);
    waiting_.values[i].insert(waiting_.values[i].end(), values.begin(), values.end());
  }
  ++rows_in_open_segment_;
  if (waiting_.times.size() >= rows_per_write_) {
    writeRows();
  }
}

void SegmentedSeries::openSegment()
{
  const auto path = layout_.directory / layout_.segmentName(rows_of_segment_.size());
  std::filesystem::create_directories(path.parent_path());
  segment_ = h5::File::create(path);
  constexpr hsize_t rows_per_chunk = 1024; // of single numbers
  detail::describe(segment_->createExtendable("time", h5::Type::float64, {}, rows_per_chunk), "s",
           "Time at the end of the step.");
  detail::describe(segment_->createExtendable("step", h5::Type::int64, {}, rows_per_chunk), "-",
           "Number of the accepted step; 0 is the initial state.");
  for (auto const& field : layout_.fields) {
    detail::describe(segment_->createExtendable("fields/" + field.name, layout_.type,
                                        layout_.rowShape(field), rows_per_write_),
             field.unit, field.description);
  }
}

void SegmentedSeries::writeRows()
{
  const std::size_t rows = waiting_.times.size();
  if (rows == 0) {
    return;
  }
  std::vector<std::vector<double>> whole;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    whole.push_back(gather_(waiting_.values[i], rows, fields_[i]->components));
    waiting_.values[i].clear();
  }
  detail::onRoot(*location_.comm, [&] {
    if (!segment_) {
      openSegment();
    }
    segment_->openDataset("time").append(waiting_.times.data(), rows);
    segment_->openDataset("step").append(waiting_.steps.data(), rows);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      segment_->openDataset("fields/" + fields_[i]->name).append(whole[i].data(), rows);
    }
  });
  waiting_.times.clear();
  waiting_.steps.clear();
}

void SegmentedSeries::closeSegment(int index)
{
  ASPERITY_ASSERT(index == static_cast<int>(rows_of_segment_.size()));
  writeRows();
  detail::onRoot(*location_.comm, [&] {
    if (segment_) {
      segment_->close();
      segment_.reset();
      detail::synchronise(layout_.directory / layout_.segmentName(rows_of_segment_.size()));
    }
  });
  rows_of_segment_.push_back(rows_in_open_segment_);
  rows_in_open_segment_ = 0;
  detail::onRoot(*location_.comm, [&] {
    detail::writeIndexFile(layout_, geometry_, rows_of_segment_);
    const std::size_t last = rows_of_segment_.size() - 1;
    if (last == 0) {
      detail::startXdmf(layout_, geometry_);
    }
    const std::int64_t rows = rows_of_segment_[last];
    detail::appendToXdmf(layout_, last, times_.data() + times_.size() - rows, rows);
  });
}

void SegmentedSeries::save(Archive& archive) const
{
  ASPERITY_ASSERT(rows_in_open_segment_ == 0);
  archive.set("rows_of_segment", rows_of_segment_);
  archive.set("times", times_);
}

void SegmentedSeries::restore(Archive const& archive)
{
  rows_of_segment_ = archive.get<std::vector<std::int64_t>>("rows_of_segment");
  times_ = archive.get<std::vector<double>>("times");
  detail::onRoot(*location_.comm, [&] {
    removeLaterSegments();
    detail::writeIndexFile(layout_, geometry_, rows_of_segment_);
    detail::startXdmf(layout_, geometry_);
    double const* times = times_.data();
    for (std::size_t i = 0; i < rows_of_segment_.size(); ++i) {
      detail::appendToXdmf(layout_, i, times, rows_of_segment_[i]);
      times += rows_of_segment_[i];
    }
  });
}

void SegmentedSeries::removeLaterSegments() const
{
  for (std::size_t i = 0; i < rows_of_segment_.size(); ++i) {
    const auto path = layout_.directory / layout_.segmentName(i);
    ASPERITY_REQUIRE(rows_of_segment_[i] == 0 || std::filesystem::exists(path),
                     path.string() << " is missing, but the checkpoint continues it. Restart in "
                                      "the directory of the earlier run.");
  }
  for (const std::size_t segment : detail::segmentsOnDisk(layout_)) {
    if (segment >= rows_of_segment_.size()) {
      std::filesystem::remove(layout_.directory / layout_.segmentName(segment));
    }
  }
}
} // namespace asperity::io
