#include "io/series/Xdmf.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/WriteFailure.hpp"
#include "io/files/DurableFile.hpp"

#include <fstream>

namespace asperity::io::detail
{
namespace
{
char const* topologyType(int nodes_per_element)
{
  switch (nodes_per_element) {
  case 2: return "TopologyType=\"Polyline\" NodesPerElement=\"2\"";
  case 3: return "TopologyType=\"Triangle\"";
  default: return "TopologyType=\"Tetrahedron\"";
  }
}

void writeMesh(std::ostream& out, SeriesLayout const& layout, GeometryFile const& geometry)
{
  const std::string group = geometry.name + ":/geometry/";
  out << "    <Topology " << topologyType(layout.nodes_per_element) << " NumberOfElements=\""
      << geometry.num_whole << "\">\n"
      << "     <DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"8\" Dimensions=\""
      << geometry.num_whole << ' ' << layout.nodes_per_element << "\">" << group
      << (geometry.isPeriodic() ? "whole_elements" : "connectivity")
      << "</DataItem>\n    </Topology>\n"
      << "    <Geometry GeometryType=\"" << (layout.dimension == 2 ? "XY" : "XYZ")
      << "\">\n     <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\""
      << layout.num_nodes << ' ' << layout.dimension << "\">" << group
      << "coordinates</DataItem>\n    </Geometry>\n";
}

// What is shown of a field; `columns` are its components, -1 is zero.
struct Attribute
{
  std::string name;
  char const* type;
  std::vector<int> columns;
};

std::string suffix(OutputField const& field, int component)
{
  if (!field.component_names.empty()) {
    return "_" + field.component_names[component];
  }
  return component < 3 ? std::string("_") + "xyz"[component] : "_" + std::to_string(component);
}

// Readers take vectors of three components; they disagree on the order of a tensor's six, and take
// nine. Of anything else each component becomes a scalar of its own.
std::vector<Attribute> attributesOf(OutputField const& field)
{
  const int components = field.components;
  const bool has_names = !field.component_names.empty();
  if (components == 1) {
    return {{field.name, "Scalar", {0}}};
  }
  if (!has_names && (components == 2 || components == 3)) {
    return {{field.name, "Vector", {0, 1, components == 3 ? 2 : -1}}};
  }
  if (components == 6) {
    return {{field.name, "Tensor", {0, 1, 2, 1, 3, 4, 2, 4, 5}}}; // of xx xy xz yy yz zz
  }
  std::vector<Attribute> scalars;
  for (int k = 0; k < components; ++k) {
    scalars.push_back({field.name + suffix(field, k), "Scalar", {k}});
  }
  return scalars;
}

// The nodes, or the elements that are drawn, the first ones of a row.
hsize_t numDrawn(SeriesLayout const& layout, GeometryFile const& geometry, OutputField const& field)
{
  return field.centring == Centring::nodes ? layout.num_nodes : geometry.num_whole;
}

std::string rowsName(SeriesLayout const& layout, std::size_t segment)
{
  const std::string name = segmentName(layout.name, segment);
  return name.substr(0, name.rfind('.')) + "_rows.h5";
}

std::string rowPath(Attribute const& attribute, std::int64_t row)
{
  return attribute.name + "/" + std::to_string(row);
}

void writeAttribute(std::ostream& out, SeriesLayout const& layout, hsize_t num_drawn,
                    OutputField const& field, Attribute const& attribute, std::string const& source)
{
  out << "    <Attribute Name=\"" << attribute.name << "\" AttributeType=\"" << attribute.type
      << "\" Center=\"" << (field.centring == Centring::nodes ? "Node" : "Cell") << "\">\n"
      << "     <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\""
      << (layout.type == h5::Type::float32 ? 4 : 8) << "\" Dimensions=\"" << num_drawn;
  if (attribute.columns.size() > 1) {
    out << ' ' << attribute.columns.size();
  }
  out << "\">" << source << "</DataItem>\n    </Attribute>\n";
}

constexpr char footer[] = "  </Grid>\n </Domain>\n</Xdmf>\n";

std::filesystem::path xdmfPath(SeriesLayout const& layout)
{
  return layout.directory / (layout.name + ".xdmf");
}

void writeHeader(SeriesLayout const& layout)
{
  std::ofstream out(xdmfPath(layout));
  out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n <Domain>\n"
      << "  <Grid Name=\"" << layout.name
      << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
      << footer;
  requireWritten(out, xdmfPath(layout));
}
} // namespace

void removeXdmf(SeriesLayout const& layout) { std::filesystem::remove(xdmfPath(layout)); }

void appendToXdmf(SeriesLayout const& layout, GeometryFile const& geometry, std::size_t segment,
                  double const* times, std::int64_t num_rows)
{
  if (num_rows == 0) {
    return; // readers crash at a collection of nothing
  }
  if (!std::filesystem::exists(xdmfPath(layout))) {
    writeHeader(layout);
  }
  std::fstream out(xdmfPath(layout), std::ios::in | std::ios::out);
  out.seekp(-static_cast<std::streamoff>(sizeof footer - 1), std::ios::end);
  const std::string rows = rowsName(layout, segment) + ":/";
  for (std::int64_t row = 0; row < num_rows; ++row) {
    out << "   <Grid Name=\"" << layout.name << "\" GridType=\"Uniform\">\n    <Time Value=\""
        << formatNumber(times[row]) << "\"/>\n";
    writeMesh(out, layout, geometry); // a reference is not taken by every reader
    for (auto const& field : layout.fields) {
      for (auto const& attribute : attributesOf(field)) {
        writeAttribute(out, layout, numDrawn(layout, geometry, field), field, attribute,
                       rows + rowPath(attribute, row));
      }
    }
    out << "   </Grid>\n";
  }
  out << footer;
  requireWritten(out, xdmfPath(layout));
}

std::filesystem::path xdmfRowsPath(SeriesLayout const& layout, std::size_t segment)
{
  return layout.directory / rowsName(layout, segment);
}

void writeXdmfRows(SeriesLayout const& layout, GeometryFile const& geometry, std::size_t segment,
                   std::int64_t num_rows)
{
  if (num_rows == 0) {
    return;
  }
  const auto path = xdmfRowsPath(layout, segment);
  h5::File file = h5::File::create(temporaryName(path));
  h5::VirtualRow source;
  source.file = std::filesystem::path(segmentName(layout.name, segment)).filename();
  for (auto const& field : layout.fields) {
    source.path = "/fields/" + field.name;
    source.shape = layout.rowShape(field);
    source.shape.insert(source.shape.begin(), static_cast<hsize_t>(num_rows));
    source.points = numDrawn(layout, geometry, field);
    for (auto const& attribute : attributesOf(field)) {
      source.columns = attribute.columns;
      for (std::int64_t row = 0; row < num_rows; ++row) {
        source.row = row;
        file.createVirtualRow(rowPath(attribute, row), layout.type, source);
      }
    }
  }
  file.close();
  replace(path);
}
} // namespace asperity::io::detail
