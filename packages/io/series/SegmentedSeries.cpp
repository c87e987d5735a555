#include "io/series/SegmentedSeries.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "io/series/Xdmf.hpp"

#include <algorithm>

namespace asperity::io
{
namespace
{
bool isOfElements(OutputField const* field) { return field->centring == Centring::elements; }

SeriesLayout makeLayout(SegmentedSeries::Options const& options, OutputDomain const& domain,
                        std::vector<OutputField const*> const& fields)
{
  SeriesLayout layout;
  layout.directory = options.directory;
  layout.name = options.name;
  layout.type = options.single_precision ? h5::Type::float32 : h5::Type::float64;
  layout.num_nodes = static_cast<hsize_t>(domain.num_global_nodes);
  layout.dimension = domain.dimension;
  layout.nodes_per_element = domain.nodes_per_element;
  for (OutputField const* field : fields) {
    layout.fields.push_back(*field);
  }
  if (std::any_of(fields.begin(), fields.end(), isOfElements)) {
    layout.num_elements = static_cast<hsize_t>(
      sumOverRanks(static_cast<GlobalOrdinal>(domain.numOwnedElements()), *domain.comm));
  }
  return layout;
}

// Chunks of about 1 MiB, so that long rows neither fill the memory nor slow down reading.
std::size_t rowsPerWrite(SegmentedSeries::Options const& options, SeriesLayout const& layout)
{
  constexpr std::size_t largest_chunk = 1 << 20;
  std::size_t longest_row = 1;
  for (auto const& field : layout.fields) {
    longest_row =
      std::max<std::size_t>(longest_row, 8 * layout.rowShape(field).front() * field.components);
  }
  return std::clamp<std::size_t>(largest_chunk / longest_row, 1, options.rows_per_write);
}

SegmentedTable::Options tableOf(SegmentedSeries::Options const& given, SeriesLayout const& layout,
                                OutputDomain const& domain)
{
  SegmentedTable::Options options;
  options.directory = layout.directory;
  options.name = layout.name;
  options.rows_per_write = rowsPerWrite(given, layout);
  options.nodes = &domain;
  options.columns = timeColumns();
  options.columns.push_back({"peak_slip_rate",
                             "m/s",
                             "Largest slip rate of the fault where friction decides on it.",
                             h5::Type::float64,
                             {}});
  for (auto const& field : layout.fields) {
    options.columns.push_back({"fields/" + field.name, field.unit, field.description, layout.type,
                               layout.rowShape(field),
                               isOfElements(&field) ? SegmentedTable::Column::Support::elements
                                                    : SegmentedTable::Column::Support::nodes,
                               componentsText(field)});
  }
  options.describe_index = [name = domain.name](h5::File& file) {
    file.setAttribute("format", "asperity series");
    file.setAttribute("format_version", std::int64_t(1));
    file.setAttribute("location", name);
    file.createGroup("fields"); // also where there is none
  };
  return options;
}
} // namespace

SegmentedSeries::SegmentedSeries(Options const& options, OutputDomain const& domain,
                                 std::vector<OutputField const*> const& fields)
    : domain_(domain)
    , fields_(fields)
    , layout_(makeLayout(options, domain, fields))
    , table_(tableOf(options, layout_, domain), domain.comm)
{
}

void SegmentedSeries::append(StepInfo const& step)
{
  std::vector<std::vector<double>> columns{
    {step.time}, {static_cast<double>(step.step)}, {step.peak_slip_rate}};
  for (OutputField const* field : fields_) {
    columns.emplace_back();
    field->values(columns.back());
    ASPERITY_ASSERT(columns.back().size() ==
                    (isOfElements(field) ? domain_.numOwnedElements() : domain_.numOwned()) *
                      field->components);
  }
  times_.push_back(step.time);
  table_.append(1, columns);
}

void SegmentedSeries::closeSegment(int index)
{
  table_.closeSegment(index);
  onRoot(*domain_.comm, [&] {
    if (index == 0) {
      detail::removeXdmf(layout_);
    }
    const std::int64_t rows = table_.rowsOfSegment().back();
    detail::writeXdmfRows(layout_, table_.geometry(), index, rows);
    detail::appendToXdmf(layout_, table_.geometry(), index, times_.data() + times_.size() - rows,
                         rows);
  });
}

void SegmentedSeries::save(Archive& archive) const
{
  table_.save(archive);
  archive.set("times", times_);
}

void SegmentedSeries::restore(Archive const& archive)
{
  table_.restore(archive);
  times_ = archive.get<std::vector<double>>("times");
  onRoot(*domain_.comm, [&] {
    detail::removeXdmf(layout_);
    double const* times = times_.data();
    for (std::size_t i = 0; i < table_.rowsOfSegment().size(); ++i) {
      const std::int64_t rows = table_.rowsOfSegment()[i];
      if (!std::filesystem::exists(detail::xdmfRowsPath(layout_, i))) { // of an older program
        detail::writeXdmfRows(layout_, table_.geometry(), i, rows);
      }
      detail::appendToXdmf(layout_, table_.geometry(), i, times, rows);
      times += rows;
    }
    for (std::size_t i = table_.rowsOfSegment().size();
         std::filesystem::remove(detail::xdmfRowsPath(layout_, i)); ++i) {
    }
  });
}
} // namespace asperity::io
