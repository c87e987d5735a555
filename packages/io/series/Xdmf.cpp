#include "io/series/Xdmf.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/WriteFailure.hpp"

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
  out << "  <Topology Name=\"elements\" " << topologyType(layout.nodes_per_element)
      << " NumberOfElements=\"" << geometry.num_whole << "\">\n"
      << "   <DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"8\" Dimensions=\""
      << geometry.num_whole << ' ' << layout.nodes_per_element << "\">" << group
      << (geometry.isPeriodic() ? "whole_elements" : "connectivity")
      << "</DataItem>\n  </Topology>\n"
      << "  <Geometry Name=\"nodes\" GeometryType=\"" << (layout.dimension == 2 ? "XY" : "XYZ")
      << "\">\n   <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\""
      << layout.num_nodes << ' ' << layout.dimension << "\">" << group
      << "coordinates</DataItem>\n  </Geometry>\n";
}

// What the attributes of the file are taken from.
struct Source
{
  SeriesLayout const& layout;
  hsize_t num_whole; // elements that are drawn, the first ones of a row
  std::size_t segment;
  std::int64_t num_rows; // of the segment's datasets
  std::int64_t row;
};

// `width` components of a field, from `first` on.
void writeAttribute(std::ostream& out, Source const& source, OutputField const& field,
                    std::string const& name, char const* type, int first, int width)
{
  const bool is_nodal = field.centring == Centring::nodes;
  const bool has_components = field.components > 1;
  const hsize_t stored = source.layout.rowShape(field).front();
  const hsize_t drawn = is_nodal ? stored : source.num_whole;
  const std::string columns = width > 1 ? ' ' + std::to_string(width) : "";
  out << "    <Attribute Name=\"" << name << "\" AttributeType=\"" << type << "\" Center=\""
      << (is_nodal ? "Node" : "Cell") << "\">\n"
      << "     <DataItem ItemType=\"HyperSlab\" Dimensions=\"" << drawn << columns
      << "\">\n      <DataItem Format=\"XML\" Dimensions=\"3 " << (has_components ? 3 : 2) << "\">"
      << source.row << " 0";
  if (has_components) {
    out << ' ' << first << " 1 1 1 1 " << drawn << ' ' << width;
  } else {
    out << " 1 1 1 " << drawn;
  }
  out << "</DataItem>\n      <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\""
      << (source.layout.type == h5::Type::float32 ? 4 : 8) << "\" Dimensions=\"" << source.num_rows
      << ' ' << stored;
  if (has_components) {
    out << ' ' << field.components;
  }
  out << "\">" << segmentName(source.layout.name, source.segment) << ":/fields/" << field.name
      << "</DataItem>\n     </DataItem>\n    </Attribute>\n";
}

std::string suffix(OutputField const& field, int component)
{
  if (!field.component_names.empty()) {
    return "_" + field.component_names[component];
  }
  return component < 3 ? std::string("_") + "xyz"[component] : "_" + std::to_string(component);
}

// ParaView takes vectors of three components and symmetric tensors of six; of others each component
// becomes a scalar of its own.
void writeField(std::ostream& out, Source const& source, OutputField const& field)
{
  const int components = field.components;
  if (components == 1 || components == 3 || components == 6) {
    char const* type = components == 1 ? "Scalar" : components == 3 ? "Vector" : "Tensor6";
    writeAttribute(out, source, field, field.name, type, 0, components);
  } else {
    for (int k = 0; k < components; ++k) {
      writeAttribute(out, source, field, field.name + suffix(field, k), "Scalar", k, 1);
    }
  }
}
constexpr char footer[] = "  </Grid>\n </Domain>\n</Xdmf>\n";

std::filesystem::path xdmfPath(SeriesLayout const& layout)
{
  return layout.directory / (layout.name + ".xdmf");
}
} // namespace

void startXdmf(SeriesLayout const& layout, GeometryFile const& geometry)
{
  std::ofstream out(xdmfPath(layout));
  out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n <Domain>\n";
  writeMesh(out, layout, geometry);
  out << "  <Grid Name=\"" << layout.name
      << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  out << footer;
  requireWritten(out, xdmfPath(layout));
}

void appendToXdmf(SeriesLayout const& layout, GeometryFile const& geometry, std::size_t segment,
                  double const* times, std::int64_t num_rows)
{
  std::fstream out(xdmfPath(layout), std::ios::in | std::ios::out);
  out.seekp(-static_cast<std::streamoff>(sizeof footer - 1), std::ios::end);
  for (std::int64_t row = 0; row < num_rows; ++row) {
    out << "   <Grid Name=\"" << layout.name << "\" GridType=\"Uniform\">\n    <Time Value=\""
        << formatNumber(times[row]) << "\"/>\n"
        << "    <Topology Reference=\"/Xdmf/Domain/Topology[1]\"/>\n"
        << "    <Geometry Reference=\"/Xdmf/Domain/Geometry[1]\"/>\n";
    for (auto const& field : layout.fields) {
      writeField(out, {layout, geometry.num_whole, segment, num_rows, row}, field);
    }
    out << "   </Grid>\n";
  }
  out << footer;
  requireWritten(out, xdmfPath(layout));
}
} // namespace asperity::io::detail
