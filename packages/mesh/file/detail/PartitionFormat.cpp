#include "mesh/file/detail/PartitionFormat.hpp"

#include "base/Errors.hpp"
#include "mesh/SplitVertices.hpp"

#include <algorithm>
#include <filesystem>

namespace asperity::mesh::detail
{
namespace
{
int positiveAttribute(MeshFileReader const& file, std::string const& name)
{
  const int value = file.integerAttribute(name);
  ASPERITY_REQUIRE(value > 0, file.where() << ": the attribute '" << name << "' = " << value
                                           << " is outside [1, inf).");
  return value;
}

void requireFormat(MeshFileReader const& file)
{
  const std::string format = file.stringAttribute("format");
  ASPERITY_REQUIRE(format == partition_format,
                   file.where() << " is no partitioned mesh: its attribute 'format' is '" << format
                                << "', not '" << partition_format
                                << "'. asperity-mesh partition makes one.");
  const int version = file.integerAttribute("version");
  ASPERITY_REQUIRE(version == partition_version,
                   file.where() << " has version " << version
                                << " of the format; this program reads version "
                                << partition_version
                                << ". Partition the mesh again: asperity-mesh partition MESH.h5 "
                                << "--parts " << positiveAttribute(file, "num_parts")
                                << " --output PARTS.h5, from the file that is not partitioned.");
}

// The attribute determines how much memory is allocated, so that a damaged one must be found
// before.
void requireRows(MeshFileReader const& file, std::string const& attribute, int number,
                 std::string const& array)
{
  const std::string path = array + "/values";
  ASPERITY_REQUIRE(file.hasDataset(path),
                   file.where() << ": '" << path
                                << "' is missing, damaged or of another shape. Partition the mesh "
                                   "again.");
  const auto num_rows = file.numRows(path);
  ASPERITY_REQUIRE(static_cast<hsize_t>(number) <= num_rows,
                   file.where() << ": the attribute '" << attribute << "' = " << number << ", but '"
                                << array << "' has " << num_rows
                                << " rows. Partition the mesh again.");
}
} // namespace

PartitionSummary readSummary(MeshFileReader const& file)
{
  requireFormat(file);
  PartitionSummary summary;
  summary.dimension = file.dimension();
  summary.num_parts = positiveAttribute(file, "num_parts");
  summary.num_vertices = positiveAttribute(file, "num_vertices");
  summary.num_cells = positiveAttribute(file, "num_cells");
  requireRows(file, "num_vertices", summary.num_vertices, "/global_ids");
  requireRows(file, "num_cells", summary.num_cells, "/cells");
  summary.period = file.numbersAttribute("period", static_cast<std::size_t>(summary.dimension));
  summary.fingerprint = file.stringAttribute("fingerprint");
  summary.options.boundary = file.stringAttribute("boundary");
  summary.options.boundary_weight = positiveAttribute(file, "boundary_weight");
  summary.region_names = file.strings("/region_names");
  summary.boundary_names = file.groupEntries("/boundaries");
  if (file.hasDataset("/faults")) {
    summary.faults = file.strings("/faults");
  }
  for (auto const& fault : summary.faults) {
    auto const& names = summary.boundary_names;
    ASPERITY_REQUIRE(std::find(names.begin(), names.end(), fault) != names.end(),
                     file.where() << ": fault '" << fault
                                  << "' is not among the boundaries. Partition the mesh again.");
  }
  return summary;
}

std::uint64_t seedOf(PartitionSummary const& summary)
{
  return Checksum()
    .add(summary.dimension)
    .add(summary.num_parts)
    .add(summary.num_vertices)
    .add(summary.num_cells)
    .add(summary.period)
    .add(summary.fingerprint)
    .add(summary.region_names)
    .add(summary.boundary_names)
    .add(summary.faults)
    .value();
}

template <int Dim>
std::string fingerprint(GlobalMesh<Dim> const& mesh)
{
  Checksum checksum;
  checksum.add(Dim).add(mesh.vertices).add(std::vector<Point<Dim>>{mesh.period});
  checksum.add(mesh.cells).add(mesh.cell_regions).add(mesh.region_names);
  for (auto const& [name, facets] : mesh.boundaries) {
    checksum.add(name).add(facets);
  }
  checksum.add(mesh.faults).add(asRows(mesh.splits));
  return hexadecimal(checksum.value());
}

// It suggests a file name: for 2 parts body_2.h5 from body.h5, or from body_8.h5 if that has 8
// parts.
std::string partitionCommand(std::string const& file_name, int num_parts, int wanted_parts)
{
  const std::filesystem::path path = file_name;
  std::string stem = path.stem().string();
  const std::string suffix = "_" + std::to_string(num_parts);
  if (stem.size() > suffix.size() && stem.substr(stem.size() - suffix.size()) == suffix) {
    stem.resize(stem.size() - suffix.size());
  }
  const std::string name = stem + "_" + std::to_string(wanted_parts) + path.extension().string();
  return "asperity-mesh partition " + file_name + " --parts " + std::to_string(wanted_parts) +
         " --output " + (path.parent_path() / name).string();
}

template std::string fingerprint(GlobalMesh<2> const&);
template std::string fingerprint(GlobalMesh<3> const&);
} // namespace asperity::mesh::detail
