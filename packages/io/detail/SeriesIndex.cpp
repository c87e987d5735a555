#include "io/detail/SeriesIndex.hpp"

#include "io/detail/DurableFile.hpp"

#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace asperity::io::detail
{
std::string SeriesLayout::segmentName(std::size_t segment) const
{
  char number[24];
  std::snprintf(number, sizeof number, "%06zu", segment);
  return "segments/" + name + "_" + number + ".h5";
}

h5::Shape SeriesLayout::rowShape(Field const& field) const
{
  h5::Shape shape{num_nodes};
  if (field.components > 1) {
    shape.push_back(static_cast<hsize_t>(field.components));
  }
  return shape;
}

std::vector<std::size_t> segmentsOnDisk(SeriesLayout const& layout)
{
  std::vector<std::size_t> segments;
  const auto folder = layout.directory / "segments";
  if (!std::filesystem::is_directory(folder)) {
    return segments;
  }
  for (auto const& entry : std::filesystem::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    const std::size_t digits = stem.find_last_of('_') + 1;
    const std::size_t segment = std::strtoul(stem.c_str() + digits, nullptr, 10);
    if ("segments/" + entry.path().filename().string() == layout.segmentName(segment)) {
      segments.push_back(segment);
    }
  }
  return segments;
}

void describe(h5::Dataset dataset, std::string const& unit, std::string const& description)
{
  dataset.setAttribute("unit", unit);
  dataset.setAttribute("description", description);
}

namespace
{
template <class T>
void writeGeometry(h5::File& file, std::string const& name, std::vector<T> const& values,
                   h5::Shape const& shape, std::string const& unit,
                   std::string const& description)
{
  constexpr bool is_real = std::is_same_v<T, double>;
  auto dataset =
    file.create("geometry/" + name, is_real ? h5::Type::float64 : h5::Type::int64, shape);
  if constexpr (is_real) {
    dataset.write(values.data());
  } else {
    const std::vector<std::int64_t> integers(values.begin(), values.end());
    dataset.write(integers.data());
  }
  describe(std::move(dataset), unit, description);
}

void writeGeometry(h5::File& file, SeriesLayout const& layout, WholeGeometry const& geometry)
{
  const hsize_t nodes = layout.num_nodes;
  const hsize_t corners = layout.nodes_per_element;
  const hsize_t dimension = layout.dimension;
  char const* units[] = {"m", "m", "m^2", "m^3"};
  writeGeometry(file, "coordinates", geometry.coordinates, {nodes, dimension}, "m",
                "Coordinates of the nodes.");
  writeGeometry(file, "weights", geometry.weights, {nodes}, units[corners - 1],
                "Lumped length, area or volume of each node.");
  writeGeometry(file, "vertex_ids", geometry.vertex_ids, {nodes}, "-",
                "Numbers of the nodes in the mesh.");
  writeGeometry(file, "connectivity", geometry.connectivity,
                {geometry.connectivity.size() / corners, corners}, "-",
                "Nodes of each element, as rows of coordinates.");
  if (!geometry.positions.empty()) {
    writeGeometry(file, "positions", geometry.positions, {nodes}, "m",
                  "Distance along the boundary from its first end.");
  }
}
} // namespace

void writeIndexFile(SeriesLayout const& layout, WholeGeometry const& geometry,
                    std::vector<std::int64_t> const& rows_of_segment)
{
  std::vector<h5::VirtualPart> parts;
  for (std::size_t i = 0; i < rows_of_segment.size(); ++i) {
    parts.push_back({layout.segmentName(i), static_cast<hsize_t>(rows_of_segment[i])});
  }
  const auto path = layout.directory / (layout.name + ".h5");
  h5::File file = h5::File::create(temporaryName(path));
  file.setAttribute("format", "asperity series");
  file.setAttribute("format_version", std::int64_t(1));
  file.setAttribute("location", layout.location);
  writeGeometry(file, layout, geometry);
  describe(file.createVirtual("time", h5::Type::float64, {}, parts), "s",
           "Time at the end of the step.");
  describe(file.createVirtual("step", h5::Type::int64, {}, parts), "-",
           "Number of the accepted step; 0 is the initial state.");
  file.createGroup("fields");
  for (auto const& field : layout.fields) {
    describe(file.createVirtual("fields/" + field.name, layout.type, layout.rowShape(field), parts),
             field.unit, field.description);
  }
  file.close();
  replace(path); // a restart makes it anew
}
} // namespace asperity::io::detail
