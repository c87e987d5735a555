#include "mesh/parallel/Partition.hpp"

#include "base/Errors.hpp"
#include "mesh/MeshQuality.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <metis.h>

#include <algorithm>

namespace asperity::mesh
{
namespace
{
// The graph of vertices that share a cell, in METIS's compressed rows; freed by METIS.
class VertexGraph
{
public:
  template <int Dim>
  explicit VertexGraph(GlobalMesh<Dim> const& mesh)
  {
    std::vector<idx_t> starts = {0}, vertices;
    for (auto const& cell : mesh.cells) {
      vertices.insert(vertices.end(), cell.begin(), cell.end());
      starts.push_back(static_cast<idx_t>(vertices.size()));
    }
    auto num_cells = static_cast<idx_t>(mesh.cells.size());
    auto num_vertices = static_cast<idx_t>(mesh.vertices.size());
    idx_t first_number = 0;
    const int status = METIS_MeshToNodal(&num_cells, &num_vertices, starts.data(), vertices.data(),
                                         &first_number, &rows, &neighbours);
    ASPERITY_ASSERT(status == METIS_OK);
  }
  ~VertexGraph()
  {
    METIS_Free(rows);
    METIS_Free(neighbours);
  }
  VertexGraph(VertexGraph const&) = delete;
  VertexGraph& operator=(VertexGraph const&) = delete;

  idx_t* rows = nullptr;
  idx_t* neighbours = nullptr;
};

// What METIS balances: the vertices by weight, and those of the boundary if there are enough of
// them for every part to have one.
struct Constraints
{
  idx_t number = 1;
  std::vector<idx_t> weights;                   // (num_vertices, number)
  std::vector<real_t> tolerances{1.03f, 1.05f}; // largest part over mean
};

template <int Dim>
Constraints constraints(GlobalMesh<Dim> const& mesh, int num_parts, PartitionOptions const& options)
{
  std::vector<idx_t> on_boundary(mesh.vertices.size(), 0);
  idx_t num_on_boundary = 0;
  if (!options.boundary.empty()) {
    for (int vertex : boundaryVertices(mesh, options.boundary)) {
      on_boundary[static_cast<std::size_t>(vertex)] = 1;
      ++num_on_boundary;
    }
  }
  Constraints result;
  result.number = num_on_boundary > 0 && num_on_boundary >= num_parts ? 2 : 1;
  for (idx_t is_there : on_boundary) {
    result.weights.push_back(is_there ? options.boundary_weight : 1);
    if (result.number == 2) {
      result.weights.push_back(is_there);
    }
  }
  return result;
}

// METIS may leave parts empty where there are hardly more vertices than parts.
void fillEmptyParts(int num_parts, std::vector<idx_t>& owners)
{
  std::vector<int> sizes(static_cast<std::size_t>(num_parts), 0);
  for (idx_t owner : owners) {
    ++sizes[static_cast<std::size_t>(owner)];
  }
  for (int part = 0; part < num_parts; ++part) {
    if (sizes[part] == 0) {
      const auto largest = std::max_element(sizes.begin(), sizes.end());
      *std::find(owners.begin(), owners.end(), static_cast<idx_t>(largest - sizes.begin())) = part;
      --*largest;
      ++sizes[part];
    }
  }
}
} // namespace

template <int Dim>
std::vector<int> partitionVertices(GlobalMesh<Dim> const& mesh, int num_parts,
                                   PartitionOptions const& options)
{
  const auto num_vertices = static_cast<idx_t>(mesh.vertices.size());
  ASPERITY_ASSERT(num_parts > 0 && options.boundary_weight > 0);
  ASPERITY_REQUIRE(num_parts <= num_vertices, "The mesh has "
                                                << num_vertices << " vertices, too few for "
                                                << num_parts << " ranks. Use fewer ranks.");
  if (num_parts == 1) {
    return std::vector<int>(mesh.vertices.size(), 0);
  }
  const VertexGraph graph(mesh);
  auto balanced = constraints(mesh, num_parts, options);
  std::vector<idx_t> owners(mesh.vertices.size(), 0);
  idx_t metis_options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(metis_options);
  metis_options[METIS_OPTION_SEED] = 1;
  idx_t size = num_vertices, parts = num_parts, num_cut_edges = 0;
  const int status =
    METIS_PartGraphKway(&size, &balanced.number, graph.rows, graph.neighbours,
                        balanced.weights.data(), nullptr, nullptr, &parts, nullptr,
                        balanced.tolerances.data(), metis_options, &num_cut_edges, owners.data());
  ASPERITY_ASSERT(status == METIS_OK);
  fillEmptyParts(num_parts, owners);
  return std::vector<int>(owners.begin(), owners.end());
}

double imbalance(std::vector<int> const& owners, int num_parts)
{
  std::vector<double> sizes(static_cast<std::size_t>(num_parts), 0.0);
  for (int owner : owners) {
    ++sizes[static_cast<std::size_t>(owner)];
  }
  return *std::max_element(sizes.begin(), sizes.end()) * num_parts /
         static_cast<double>(owners.size());
}

double imbalance(std::vector<int> const& owners, int num_parts, std::vector<int> const& vertices)
{
  std::vector<int> their_owners;
  for (int vertex : vertices) {
    their_owners.push_back(owners[static_cast<std::size_t>(vertex)]);
  }
  return imbalance(their_owners, num_parts);
}

template <int Dim>
Mesh<Dim> distribute(GlobalMesh<Dim> const& mesh, Communicator const& communicator,
                     PartitionOptions const& options)
{
  const int num_ranks = communicator.getSize();
  std::vector<int> owners(mesh.vertices.size(), 0);
  if (num_ranks > 1) {
    // All ranks throw the same error if the input is wrong; all take the partition of rank 0.
    owners = partitionVertices(mesh, num_ranks, options);
    Teuchos::broadcast(communicator, 0, static_cast<int>(owners.size()), owners.data());
  }
  return localPart(mesh, owners, communicator.getRank());
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::vector<int> partitionVertices(GlobalMesh<Dim> const&, int,                         \
                                              PartitionOptions const&);                            \
  template Mesh<Dim> distribute(GlobalMesh<Dim> const&, Communicator const&,                       \
                                PartitionOptions const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh
