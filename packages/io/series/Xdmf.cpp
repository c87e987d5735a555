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

// One row of a segment, whose datasets have num_rows rows.
struct Slab
{
  std::string file;
  std::int64_t num_rows;
  std::int64_t row;
};

// All three components if component < 0, else that one.
void writeAttribute(std::ostream& out, SeriesLayout const& layout, OutputField const& field,
                    Slab const& slab, std::string const& name, int component)
{
  const bool is_vector = component < 0;
  const bool has_components = field.components > 1;
  const hsize_t nodes = layout.num_nodes;
  out << "    <Attribute Name=\"" << name << "\" AttributeType=\""
      << (is_vector ? "Vector" : "Scalar") << "\" Center=\"Node\">\n"
      << "     <DataItem ItemType=\"HyperSlab\" Dimensions=\"" << nodes << (is_vector ? " 3" : "")
      << "\">\n      <DataItem Format=\"XML\" Dimensions=\"3 " << (has_components ? 3 : 2) << "\">";
  if (has_components) {
    out << slab.row << " 0 " << (is_vector ? 0 : component) << " 1 1 1 1 " << nodes << ' '
        << (is_vector ? 3 : 1);
  } else {
    out << slab.row << " 0 1 1 1 " << nodes;
  }
  out << "</DataItem>\n      <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\""
      << (layout.type == h5::Type::float32 ? 4 : 8) << "\" Dimensions=\"" << slab.num_rows << ' '
      << nodes;
  if (has_components) {
    out << ' ' << field.components;
  }
  out << "\">" << slab.file << ":/fields/" << field.name
      << "</DataItem>\n     </DataItem>\n    </Attribute>\n";
}

// ParaView takes vectors of three components; of two, each becomes a scalar of its own.
void writeField(std::ostream& out, SeriesLayout const& layout, OutputField const& field,
                Slab const& slab)
{
  if (field.components == 3) {
    writeAttribute(out, layout, field, slab, field.name, -1);
  } else if (field.components == 1) {
    writeAttribute(out, layout, field, slab, field.name, 0);
  } else {
    for (int k = 0; k < field.components; ++k) {
      const std::string suffix = k < 3 ? std::string("_") + "xyz"[k] : "_" + std::to_string(k);
      writeAttribute(out, layout, field, slab, field.name + suffix, k);
    }
  }
}
constexpr char footer[] = "  </Grid>\n </Domain>\n</Xdmf>\n";

std::filesystem::path xdmfPath(SeriesLayout const& layout)
{
  return layout.directory / (layout.name + ".xdmf");
}

void closeChecked(std::ostream& out, SeriesLayout const& layout)
{
  out << footer << std::flush;
  if (!out) {
    auto const path = xdmfPath(layout);
    throw OutputError(path.string() + " cannot be written. " + whyNotWritten(path));
  }
}
} // namespace

void startXdmf(SeriesLayout const& layout, GeometryFile const& geometry)
{
  std::ofstream out(xdmfPath(layout));
  out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n <Domain>\n";
  writeMesh(out, layout, geometry);
  out << "  <Grid Name=\"" << layout.name
      << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  closeChecked(out, layout);
}

void appendToXdmf(SeriesLayout const& layout, std::size_t segment, double const* times,
                  std::int64_t num_rows)
{
  std::fstream out(xdmfPath(layout), std::ios::in | std::ios::out);
  out.seekp(-static_cast<std::streamoff>(sizeof footer - 1), std::ios::end);
  for (std::int64_t row = 0; row < num_rows; ++row) {
    out << "   <Grid Name=\"" << layout.name << "\" GridType=\"Uniform\">\n    <Time Value=\""
        << formatNumber(times[row]) << "\"/>\n"
        << "    <Topology Reference=\"/Xdmf/Domain/Topology[1]\"/>\n"
        << "    <Geometry Reference=\"/Xdmf/Domain/Geometry[1]\"/>\n";
    for (auto const& field : layout.fields) {
      writeField(out, layout, field, {segmentName(layout.name, segment), num_rows, row});
    }
    out << "   </Grid>\n";
  }
  closeChecked(out, layout);
}
} // namespace asperity::io::detail
