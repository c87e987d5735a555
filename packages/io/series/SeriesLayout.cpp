#include "io/series/SeriesLayout.hpp"

#include <type_traits>
#include <utility>

namespace asperity::io
{
h5::Shape rowShape(std::size_t num_points, int components)
{
  h5::Shape shape{num_points};
  if (components > 1) {
    shape.push_back(static_cast<hsize_t>(components));
  }
  return shape;
}

h5::Shape SeriesLayout::rowShape(OutputField const& field) const
{
  return io::rowShape(field.centring == Centring::nodes ? num_nodes : num_elements,
                      field.components);
}

std::string componentsText(OutputField const& field)
{
  std::string text;
  for (auto const& name : field.component_names) {
    text += (text.empty() ? "" : " ") + name;
  }
  return text;
}

std::vector<SegmentedTable::Column> timeColumns()
{
  return {
    {"time", "s", "Time at the end of the step.", h5::Type::float64, {}},
    {"step", "-", "Number of the accepted step; 0 is the initial state.", h5::Type::int64, {}}};
}

template <class T>
void writeDataset(h5::File& file, std::string const& path, std::vector<T> const& values,
                  h5::Shape const& shape, std::string const& unit, std::string const& description)
{
  constexpr bool is_real = std::is_same_v<T, double>;
  auto dataset = file.create(path, is_real ? h5::Type::float64 : h5::Type::int64, shape);
  if constexpr (is_real) {
    dataset.write(values.data());
  } else {
    const std::vector<std::int64_t> integers(values.begin(), values.end());
    dataset.write(integers.data());
  }
  describe(std::move(dataset), unit, description);
}

template void writeDataset(h5::File&, std::string const&, std::vector<double> const&,
                           h5::Shape const&, std::string const&, std::string const&);
template void writeDataset(h5::File&, std::string const&, std::vector<GlobalOrdinal> const&,
                           h5::Shape const&, std::string const&, std::string const&);
} // namespace asperity::io
