#include "mesh/file/MeshFile.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/parallel/Agreement.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/file/detail/CompleteFile.hpp"
#include "mesh/file/detail/MeshFileReader.hpp"
#include "mesh/parallel/Partition.hpp"

namespace asperity::mesh
{
namespace
{
constexpr char format_name[] = "asperity-mesh";
constexpr int format_version = 1;

std::string facetsPath(std::string const& boundary)
{
  return "/boundaries/" + boundary + "/facets";
}

template <int Dim>
std::string checksumOf(GlobalMesh<Dim> const& mesh)
{
  Checksum checksum;
  checksum.add(Dim).add(mesh.vertices).add(mesh.cells).add(mesh.cell_regions);
  checksum.add(mesh.region_names).add(std::vector<Point<Dim>>{mesh.period});
  for (auto const& [name, facets] : mesh.boundaries) {
    checksum.add(name).add(facets);
  }
  return hexadecimal(checksum.value());
}

// Files that other programs write may have no checksum.
template <int Dim>
void requireChecksum(GlobalMesh<Dim> const& mesh, detail::MeshFileReader const& file)
{
  ASPERITY_REQUIRE(
    !file.hasAttribute("checksum") || file.stringAttribute("checksum") == checksumOf(mesh),
    file.where() << " is damaged: its content does not fit its checksum. If you have "
                    "edited it, remove its attribute 'checksum'.");
}

template <int Dim>
void writeContents(h5::File& file, GlobalMesh<Dim> const& mesh)
{
  constexpr auto fixed = h5::TextLength::fixed;
  file.setAttribute("format", format_name, fixed);
  file.setAttribute("checksum", checksumOf(mesh), fixed);
  file.setAttribute("version", format_version);
  file.setAttribute("dimension", Dim);
  if (mesh.period != Point<Dim>{}) {
    file.setAttribute("period", std::vector<double>(mesh.period.begin(), mesh.period.end()));
  }
  detail::store(file, "/vertices", mesh.vertices);
  detail::store(file, "/cells", mesh.cells);
  detail::store(file, "/cell_regions", mesh.cell_regions);
  file.createTexts("/region_names", mesh.region_names, fixed);
  file.createGroup("/boundaries");
  for (auto const& [name, facets] : mesh.boundaries) {
    file.createGroup("/boundaries/" + name);
    detail::store(file, facetsPath(name), facets);
  }
}

// Also checks format and version.
int readDimension(detail::MeshFileReader const& file)
{
  const std::string format = file.stringAttribute("format");
  ASPERITY_REQUIRE(format == format_name, file.where()
                                            << " is no mesh: its attribute 'format' is '" << format
                                            << "', not '" << format_name << "'.");
  const int version = file.integerAttribute("version");
  ASPERITY_REQUIRE(version == format_version, file.where()
                                                << " has version " << version
                                                << " of the format; this program reads version "
                                                << format_version << '.');
  return file.dimension();
}
} // namespace

template <int Dim>
void writeMesh(GlobalMesh<Dim> const& mesh, std::string const& file_name)
{
  ASPERITY_ASSERT(mesh.splits.empty());
  detail::writeCompletely(file_name, boundaryNames(mesh),
                          [&](h5::File& file) { writeContents(file, mesh); });
}

template <int Dim>
GlobalMesh<Dim> readMesh(std::string const& file_name)
{
  const detail::MeshFileReader file(file_name);
  const int dimension = readDimension(file);
  ASPERITY_REQUIRE(dimension == Dim, file.where() << " has dimension " << dimension << ", not "
                                                  << Dim << " as needed here.");
  GlobalMesh<Dim> mesh;
  mesh.vertices = file.numberRows<Dim>("/vertices");
  if (file.hasAttribute("period")) {
    const auto period = file.numbersAttribute("period", Dim);
    std::copy(period.begin(), period.end(), mesh.period.begin());
  }
  mesh.cells = file.integerRows<Dim + 1>("/cells");
  mesh.cell_regions = file.integers("/cell_regions");
  mesh.region_names = file.strings("/region_names");
  for (auto const& name : file.groupEntries("/boundaries")) {
    mesh.boundaries[name] = file.integerRows<Dim>(facetsPath(name));
  }
  checkMesh(mesh, file.where()); // first, since its messages are more specific
  requireChecksum(mesh, file);
  orientFacets(mesh);
  return mesh;
}

template <int Dim>
GlobalMesh<Dim> readMesh(std::string const& file_name, Communicator const& communicator)
{
  GlobalMesh<Dim> mesh;
  onRoot(communicator, [&] { mesh = readMesh<Dim>(file_name); });
  broadcast(mesh, communicator);
  return mesh;
}

int meshDimension(std::string const& file_name)
{
  return readDimension(detail::MeshFileReader(file_name));
}

template void writeMesh(GlobalMesh<2> const&, std::string const&);
template void writeMesh(GlobalMesh<3> const&, std::string const&);
template GlobalMesh<2> readMesh(std::string const&);
template GlobalMesh<3> readMesh(std::string const&);
template GlobalMesh<2> readMesh(std::string const&, Communicator const&);
template GlobalMesh<3> readMesh(std::string const&, Communicator const&);
} // namespace asperity::mesh
