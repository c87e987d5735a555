#include "mesh/Partition.hpp"

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

template <int Dim>
std::vector<idx_t> vertexWeights(GlobalMesh<Dim> const& mesh, PartitionOptions const& options)
{
  std::vector<idx_t> weights(mesh.vertices.size(), 1);
  if (!options.boundary.empty()) {
    for (int vertex : boundaryVertices(mesh, options.boundary)) {
      weights[static_cast<std::size_t>(vertex)] = options.boundary_weight;
    }
  }
  return weights;
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

// Local numbers: owned vertices, then ghosts, each in global order; -1 elsewhere.
template <int Dim>
std::vector<int> numberLocally(GlobalMesh<Dim> const& mesh, std::vector<int> const& owners,
                               int rank, Mesh<Dim>& part)
{
  std::vector<bool> is_ghost(mesh.vertices.size(), false);
  for (auto const& cell : mesh.cells) {
    const auto is_mine = [&](int vertex) { return owners[vertex] == rank; };
    if (std::any_of(cell.begin(), cell.end(), is_mine)) {
      for (int vertex : cell) {
        is_ghost[vertex] = !is_mine(vertex);
      }
    }
  }
  std::vector<int> local(mesh.vertices.size(), -1);
  const auto add = [&](std::size_t vertex) {
    local[vertex] = static_cast<int>(part.vertices.size());
    part.vertices.push_back(mesh.vertices[vertex]);
    part.global_ids.push_back(static_cast<GlobalOrdinal>(vertex));
  };
  for (std::size_t v = 0; v < local.size(); ++v) {
    if (owners[v] == rank) {
      add(v);
    }
  }
  part.num_owned = static_cast<int>(part.vertices.size());
  for (std::size_t v = 0; v < local.size(); ++v) {
    if (is_ghost[v]) {
      add(v);
    }
  }
  return local;
}

// Of a cell or facet. All its vertices are local if one is owned.
template <std::size_t N>
bool touchesOwned(std::array<int, N> const& local_simplex, int num_owned)
{
  return std::any_of(local_simplex.begin(), local_simplex.end(),
                     [&](int vertex) { return vertex >= 0 && vertex < num_owned; });
}

template <std::size_t N>
std::array<int, N> renumbered(std::array<int, N> simplex, std::vector<int> const& local)
{
  for (int& vertex : simplex) {
    vertex = local[static_cast<std::size_t>(vertex)];
  }
  return simplex;
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
  auto weights = vertexWeights(mesh, options);
  std::vector<idx_t> owners(mesh.vertices.size(), 0);
  idx_t metis_options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(metis_options);
  metis_options[METIS_OPTION_SEED] = 1;
  idx_t size = num_vertices, num_constraints = 1, parts = num_parts, num_cut_edges = 0;
  const int status = METIS_PartGraphKway(&size, &num_constraints, graph.rows, graph.neighbours,
                                         weights.data(), nullptr, nullptr, &parts, nullptr, nullptr,
                                         metis_options, &num_cut_edges, owners.data());
  ASPERITY_ASSERT(status == METIS_OK);
  fillEmptyParts(num_parts, owners);
  return std::vector<int>(owners.begin(), owners.end());
}

template <int Dim>
Mesh<Dim> localPart(GlobalMesh<Dim> const& mesh, std::vector<int> const& owners, int rank)
{
  ASPERITY_ASSERT(owners.size() == mesh.vertices.size());
  Mesh<Dim> part;
  part.num_global_vertices = static_cast<GlobalOrdinal>(mesh.vertices.size());
  part.region_names = mesh.region_names;
  const auto local = numberLocally(mesh, owners, rank, part);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto cell = renumbered(mesh.cells[c], local);
    if (touchesOwned(cell, part.num_owned)) {
      part.cells.push_back(cell);
      part.cell_regions.push_back(mesh.cell_regions[c]);
    }
  }
  for (auto const& [name, facets] : mesh.boundaries) {
    auto& local_facets = part.boundaries[name];
    for (auto const& facet : facets) {
      const auto local_facet = renumbered(facet, local);
      if (touchesOwned(local_facet, part.num_owned)) {
        local_facets.push_back(local_facet);
      }
    }
  }
  return part;
}

template <int Dim>
Mesh<Dim> distribute(GlobalMesh<Dim> const& mesh, Communicator const& communicator,
                     PartitionOptions const& options)
{
  const int num_ranks = communicator.getSize();
  std::vector<int> owners(mesh.vertices.size(), 0);
  if (num_ranks > 1) {
    // Every rank throws alike if the input is at fault; the answer is that of rank 0.
    owners = partitionVertices(mesh, num_ranks, options);
    Teuchos::broadcast(communicator, 0, static_cast<int>(owners.size()), owners.data());
  }
  return localPart(mesh, owners, communicator.getRank());
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::vector<int> partitionVertices(GlobalMesh<Dim> const&, int,                         \
                                              PartitionOptions const&);                            \
  template Mesh<Dim> localPart(GlobalMesh<Dim> const&, std::vector<int> const&, int);              \
  template Mesh<Dim> distribute(GlobalMesh<Dim> const&, Communicator const&,                       \
                                PartitionOptions const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh
