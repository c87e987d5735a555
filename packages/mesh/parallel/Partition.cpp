#include "mesh/parallel/Partition.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/SplitVertices.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <metis.h>

#include <algorithm>

namespace asperity::mesh
{
namespace
{
// The nodes of the graph that METIS partitions: those of the mesh before the split. A node is a
// vertex, or all vertices at one place of a fault inside the body, which thus get one owner.
struct Nodes
{
  std::vector<idx_t> of_vertex; // (num_vertices)
  idx_t count = 0;

  template <int Dim>
  explicit Nodes(GlobalMesh<Dim> const& mesh) : of_vertex(mesh.vertices.size())
  {
    const FaultPairs pairs(mesh.splits);
    for (std::size_t v = 0; v < of_vertex.size(); ++v) {
      if (!pairs.find(static_cast<int>(v))) {
        of_vertex[v] = count++;
      }
    }
    for (auto const& pair : mesh.splits) {
      of_vertex[pair.plus] = of_vertex[pairs.placeOf(pair.plus)];
    }
  }
};

// The graph of nodes that share a cell, in METIS's compressed rows; freed by METIS.
class NodeGraph
{
public:
  template <int Dim>
  NodeGraph(GlobalMesh<Dim> const& mesh, Nodes const& nodes)
  {
    std::vector<idx_t> starts = {0}, vertices;
    for (auto const& cell : mesh.cells) {
      for (int vertex : cell) {
        vertices.push_back(nodes.of_vertex[static_cast<std::size_t>(vertex)]);
      }
      starts.push_back(static_cast<idx_t>(vertices.size()));
    }
    auto num_cells = static_cast<idx_t>(mesh.cells.size());
    idx_t num_vertices = nodes.count;
    idx_t first_number = 0;
    const int status = METIS_MeshToNodal(&num_cells, &num_vertices, starts.data(), vertices.data(),
                                         &first_number, &rows, &neighbours);
    ASPERITY_ASSERT(status == METIS_OK);
  }
  ~NodeGraph()
  {
    METIS_Free(rows);
    METIS_Free(neighbours);
  }
  NodeGraph(NodeGraph const&) = delete;
  NodeGraph& operator=(NodeGraph const&) = delete;

  idx_t* rows = nullptr;
  idx_t* neighbours = nullptr;
};

// The quantities that METIS balances: the weights of the vertices and, if there are enough vertices
// on the boundary for every part to have one, the number of those.
struct Constraints
{
  idx_t number = 1;
  std::vector<idx_t> weights;                   // (num_nodes, number)
  std::vector<real_t> tolerances{1.03f, 1.05f}; // largest part over mean
};

template <class Simplices>
std::vector<idx_t> timesUsed(Simplices const& simplices, std::size_t num_vertices)
{
  std::vector<idx_t> times(num_vertices, 0);
  for (auto const& simplex : simplices) {
    for (int vertex : simplex) {
      ++times[static_cast<std::size_t>(vertex)];
    }
  }
  return times;
}

template <int Dim>
Constraints constraints(GlobalMesh<Dim> const& mesh, Nodes const& nodes, int num_parts,
                        PartitionOptions const& options)
{
  const std::size_t num_vertices = mesh.vertices.size();
  std::vector<idx_t> on_boundary(num_vertices, 0), everywhere(num_vertices, 1);
  idx_t num_on_boundary = 0;
  if (!options.boundary.empty()) {
    on_boundary = timesUsed(boundaryFacets(mesh, options.boundary), num_vertices);
    num_on_boundary = static_cast<idx_t>(boundaryVertices(mesh, options.boundary).size());
  }
  if (options.by_cells) {
    everywhere = timesUsed(mesh.cells, num_vertices);
  }
  Constraints result;
  result.number = num_on_boundary > 0 && num_on_boundary >= num_parts ? 2 : 1;
  const auto begin_of = [number = static_cast<std::size_t>(result.number)](idx_t node) {
    return static_cast<std::size_t>(node) * number;
  };
  result.weights.assign(begin_of(nodes.count), 0);
  for (std::size_t v = 0; v < num_vertices; ++v) {
    idx_t* weights = &result.weights[begin_of(nodes.of_vertex[v])];
    const bool is_heavy = on_boundary[v] > 0 && !options.by_cells;
    weights[0] += is_heavy ? options.boundary_weight : everywhere[v];
    if (result.number == 2) {
      weights[1] += options.by_cells ? on_boundary[v] : std::min<idx_t>(on_boundary[v], 1);
    }
  }
  return result;
}

// METIS may leave parts empty where there are hardly more nodes than parts.
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
  const Nodes nodes(mesh);
  ASPERITY_ASSERT(num_parts > 0 && options.boundary_weight > 0);
  ASPERITY_REQUIRE(num_parts <= nodes.count, "The mesh has "
                                               << nodes.count << " vertices, too few for "
                                               << num_parts << " ranks. Use fewer ranks.");
  if (num_parts == 1) {
    return std::vector<int>(mesh.vertices.size(), 0);
  }
  const NodeGraph graph(mesh, nodes);
  auto balanced = constraints(mesh, nodes, num_parts, options);
  std::vector<idx_t> owners(static_cast<std::size_t>(nodes.count), 0);
  idx_t metis_options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(metis_options);
  metis_options[METIS_OPTION_SEED] = 1;
  idx_t size = nodes.count, parts = num_parts, num_cut_edges = 0;
  const int status =
    METIS_PartGraphKway(&size, &balanced.number, graph.rows, graph.neighbours,
                        balanced.weights.data(), nullptr, nullptr, &parts, nullptr,
                        balanced.tolerances.data(), metis_options, &num_cut_edges, owners.data());
  ASPERITY_ASSERT(status == METIS_OK);
  fillEmptyParts(num_parts, owners);
  std::vector<int> of_vertices;
  for (idx_t node : nodes.of_vertex) {
    of_vertices.push_back(static_cast<int>(owners[static_cast<std::size_t>(node)]));
  }
  return of_vertices;
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
  their_owners.reserve(vertices.size());
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
    onRoot(communicator, [&] { owners = partitionVertices(mesh, num_ranks, options); });
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
