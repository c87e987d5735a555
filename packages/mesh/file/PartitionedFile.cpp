#include "mesh/file/PartitionedFile.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Messages.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/SplitVertices.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/detail/Assembly.hpp"
#include "mesh/file/detail/PartCheck.hpp"
#include "mesh/file/detail/SlabReader.hpp"
#include "mesh/parallel/detail/Broadcast.hpp"

#include <fstream>

namespace asperity::mesh
{
namespace
{
std::string whereIs(std::string const& file_name) { return "Mesh file '" + file_name + "'"; }

void requireDimension(std::string const& file_name, PartitionSummary const& summary, int wanted)
{
  ASPERITY_REQUIRE(summary.dimension == wanted, whereIs(file_name)
                                                  << " has dimension " << summary.dimension
                                                  << ", not " << wanted << " as needed here.");
}

// Rank 0 reads and sends the result to all others.
PartitionSummary summaryOnEveryRank(std::string const& file_name, Communicator const& communicator)
{
  PartitionSummary summary;
  onRoot(communicator, [&] { summary = partitionSummary(file_name); });
  const detail::Broadcast from_root(communicator);
  for (int* number : {&summary.dimension, &summary.num_parts, &summary.num_vertices,
                      &summary.num_cells, &summary.options.boundary_weight}) {
    *number = from_root.size(static_cast<std::size_t>(*number));
  }
  from_root.values(summary.period);
  from_root.text(summary.fingerprint);
  from_root.text(summary.options.boundary);
  from_root.texts(summary.region_names);
  from_root.texts(summary.boundary_names);
  from_root.texts(summary.faults);
  return summary;
}

// The number that rank 0 finds, on every rank.
int fromRoot(Communicator const& communicator, std::function<int()> const& find)
{
  int number = 0;
  onRoot(communicator, [&] { number = find(); });
  Teuchos::broadcast(communicator, 0, &number);
  return number;
}

// The mesh of a part; valid only if reader.problem() is empty afterwards.
template <int Dim>
Mesh<Dim> readMeshOf(detail::SlabReader& reader, PartitionSummary const& summary, int part)
{
  Mesh<Dim> mesh;
  mesh.num_global_vertices = summary.num_vertices;
  std::copy_n(summary.period.begin(), Dim, mesh.period.begin());
  mesh.region_names = summary.region_names;
  const auto num_owned = reader.read<int>("/num_owned", part);
  mesh.num_owned = num_owned.size() == 1 ? num_owned[0] : 0;
  mesh.vertices = reader.read<Point<Dim>>("/vertices", part);
  mesh.global_ids = reader.read<GlobalOrdinal>("/global_ids", part);
  mesh.cells = reader.read<typename Mesh<Dim>::Cell>("/cells", part);
  mesh.cell_regions = reader.read<int>("/cell_regions", part);
  for (auto const& name : summary.boundary_names) {
    mesh.boundaries[name] =
      reader.read<typename Mesh<Dim>::Facet>(detail::boundaryArray(name, "facets"), part);
  }
  mesh.splits = fromRows(reader.read<SplitRow>("/splits", part));
  mesh.faults = summary.faults;
  return mesh;
}

template <int Dim>
NumberedPart<Dim> readNumbered(detail::SlabReader& reader, PartitionSummary const& summary,
                               int part)
{
  NumberedPart<Dim> numbered;
  numbered.mesh = readMeshOf<Dim>(reader, summary, part);
  numbered.cells = reader.read<int>("/cell_ids", part);
  for (auto const& name : summary.boundary_names) {
    numbered.facets[name] = reader.read<int>(detail::boundaryArray(name, "facet_ids"), part);
  }
  return numbered;
}
} // namespace

PartitionSummary partitionSummary(std::string const& file_name)
{
  return detail::readSummary(detail::MeshFileReader(file_name));
}

template <int Dim>
Mesh<Dim> readPart(std::string const& file_name, RCP<const Communicator> const& communicator)
{
  const auto summary = summaryOnEveryRank(file_name, *communicator);
  requireDimension(file_name, summary, Dim);
  const int num_ranks = communicator->getSize();
  const int rank = communicator->getRank();
  ASPERITY_REQUIRE(summary.num_parts == num_ranks,
                   whereIs(file_name)
                     << " is partitioned for " << summary.num_parts
                     << (summary.num_parts == 1 ? " rank" : " ranks") << ", and this run has "
                     << num_ranks << ". Use as many, or partition it again: "
                     << detail::partitionCommand(file_name, summary.num_parts, num_ranks));
  // All ranks open the file together; if only some of them failed, the others would wait forever.
  onEveryRank(*communicator, [&] {
    ASPERITY_REQUIRE(std::ifstream(file_name).good(),
                     whereIs(file_name) << " cannot be read by rank " << rank
                                        << ". Is it in a folder that all nodes share?");
  });
  detail::SlabReader reader(file_name, summary);
  auto mesh = readMeshOf<Dim>(reader, summary, rank);
  onEveryRank(*communicator, [&] {
    ASPERITY_REQUIRE(reader.problem().empty(), reader.problem());
    detail::checkPart(mesh, whereIs(file_name) + ", part " + std::to_string(rank));
  });
  const auto num_owned = sumOverRanks(GlobalOrdinal(mesh.num_owned), *communicator);
  ASPERITY_REQUIRE(num_owned == summary.num_vertices,
                   whereIs(file_name) << ": its parts own " << num_owned << " vertices of "
                                      << summary.num_vertices << ". Partition the mesh again.");
  return mesh;
}

template <int Dim>
GlobalMesh<Dim> readParts(std::string const& file_name)
{
  const auto summary = partitionSummary(file_name);
  requireDimension(file_name, summary, Dim);
  detail::SlabReader reader(file_name, summary);
  detail::Assembly<Dim> assembly(summary);
  for (int part = 0; part < summary.num_parts; ++part) {
    const auto numbered = readNumbered<Dim>(reader, summary, part);
    ASPERITY_REQUIRE(reader.problem().empty(), reader.problem());
    const std::string where = whereIs(file_name) + ", part " + std::to_string(part);
    detail::checkPart(numbered.mesh, where);
    assembly.add(numbered, where);
  }
  auto mesh = assembly.finish(whereIs(file_name));
  checkMesh(mesh, whereIs(file_name));
  ASPERITY_REQUIRE(detail::fingerprint(mesh) == summary.fingerprint,
                   whereIs(file_name) << ": its parts are not of the mesh with fingerprint "
                                      << summary.fingerprint << ". Partition the mesh again.");
  return mesh;
}

bool isPartitioned(std::string const& file_name)
{
  const detail::MeshFileReader file(file_name);
  if (file.stringAttribute("format") == detail::partition_format) {
    return true;
  }
  meshDimension(file_name); // throws if it is no mesh either
  return false;
}

bool isPartitioned(std::string const& file_name, Communicator const& communicator)
{
  return fromRoot(communicator, [&] { return isPartitioned(file_name) ? 1 : 0; }) == 1;
}

int fileDimension(std::string const& file_name, Communicator const& communicator)
{
  return fromRoot(communicator, [&] {
    return isPartitioned(file_name) ? partitionSummary(file_name).dimension
                                    : meshDimension(file_name);
  });
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template Mesh<Dim> readPart(std::string const&, RCP<const Communicator> const&);                 \
  template GlobalMesh<Dim> readParts(std::string const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh
