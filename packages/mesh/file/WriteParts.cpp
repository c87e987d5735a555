#include "mesh/file/PartitionedFile.hpp"

#include "base/Errors.hpp"
#include "hdf5/File.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/SplitVertices.hpp"
#include "mesh/file/detail/CompleteFile.hpp"
#include "mesh/file/detail/PartitionFormat.hpp"

namespace asperity::mesh
{
namespace
{
// Writes the arrays, each with the rows of all parts.
template <int Dim>
class PartsWriter
{
public:
  PartsWriter(h5::File& file, PartitionSummary const& summary,
              std::vector<NumberedPart<Dim>> const& parts)
      : file_(file)
      , summary_(summary)
      , seed_(detail::seedOf(summary))
      , parts_(parts)
  {
  }

  void writeArrays() const
  {
    using Part = NumberedPart<Dim>;
    array("/num_owned", [](Part const& part) { return std::vector<int>{part.mesh.num_owned}; });
    array("/vertices", [](Part const& part) { return part.mesh.vertices; });
    array("/global_ids", [](Part const& part) { return part.mesh.global_ids; });
    array("/cells", [](Part const& part) { return part.mesh.cells; });
    array("/cell_regions", [](Part const& part) { return part.mesh.cell_regions; });
    array("/cell_ids", [](Part const& part) { return part.cells; });
    array("/splits", [](Part const& part) { return asRows(part.mesh.splits); });
    file_.createGroup("/boundaries");
    for (auto const& name : summary_.boundary_names) {
      file_.createGroup("/boundaries/" + name);
      array(detail::boundaryArray(name, "facets"),
            [&](Part const& part) { return part.mesh.boundaries.at(name); });
      array(detail::boundaryArray(name, "facet_ids"),
            [&](Part const& part) { return part.facets.at(name); });
    }
  }

private:
  template <class RowsOf>
  void array(std::string const& path, RowsOf rows_of) const
  {
    decltype(rows_of(parts_.front())) all;
    std::vector<long long> offsets = {0};
    std::vector<std::uint64_t> checksums;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      auto const& rows = rows_of(parts_[p]);
      all.insert(all.end(), rows.begin(), rows.end());
      offsets.push_back(static_cast<long long>(all.size()));
      checksums.push_back(detail::partChecksum(seed_, path, static_cast<int>(p), rows));
    }
    file_.createGroup(path);
    detail::store(file_, path + "/values", all);
    detail::store(file_, path + "/offsets", offsets);
    detail::store(file_, path + "/checksums", checksums);
  }

  h5::File& file_;
  PartitionSummary const& summary_;
  std::uint64_t seed_;
  std::vector<NumberedPart<Dim>> const& parts_;
};

template <int Dim>
PartitionSummary summaryOf(GlobalMesh<Dim> const& mesh, int num_parts,
                           PartitionOptions const& options)
{
  PartitionSummary summary;
  summary.dimension = Dim;
  summary.num_parts = num_parts;
  summary.num_vertices = static_cast<int>(mesh.vertices.size());
  summary.num_cells = static_cast<int>(mesh.cells.size());
  summary.period.assign(mesh.period.begin(), mesh.period.end());
  summary.fingerprint = detail::fingerprint(mesh);
  summary.options = options;
  summary.region_names = mesh.region_names;
  summary.boundary_names = boundaryNames(mesh);
  summary.faults = mesh.faults;
  return summary;
}

void writeSummary(h5::File& file, PartitionSummary const& summary)
{
  constexpr auto fixed = h5::TextLength::fixed;
  file.setAttribute("format", detail::partition_format, fixed);
  file.setAttribute("version", detail::partition_version);
  file.setAttribute("dimension", summary.dimension);
  file.setAttribute("num_parts", summary.num_parts);
  file.setAttribute("num_vertices", summary.num_vertices);
  file.setAttribute("num_cells", summary.num_cells);
  file.setAttribute("period", summary.period);
  file.setAttribute("fingerprint", summary.fingerprint, fixed);
  file.setAttribute("boundary", summary.options.boundary, fixed);
  file.setAttribute("boundary_weight", summary.options.boundary_weight);
  file.createTexts("/region_names", summary.region_names, fixed);
  if (!summary.faults.empty()) {
    file.createTexts("/faults", summary.faults, fixed);
  }
}
} // namespace

template <int Dim>
void writeParts(GlobalMesh<Dim> const& mesh, std::vector<int> const& owners, int num_parts,
                PartitionOptions const& options, std::string const& file_name)
{
  const auto summary = summaryOf(mesh, num_parts, options);
  const auto parts = localParts(mesh, owners, num_parts);
  detail::writeCompletely(file_name, summary.boundary_names, [&](h5::File& file) {
    writeSummary(file, summary);
    PartsWriter<Dim>(file, summary, parts).writeArrays();
  });
}

template void writeParts(GlobalMesh<2> const&, std::vector<int> const&, int,
                         PartitionOptions const&, std::string const&);
template void writeParts(GlobalMesh<3> const&, std::vector<int> const&, int,
                         PartitionOptions const&, std::string const&);
} // namespace asperity::mesh
