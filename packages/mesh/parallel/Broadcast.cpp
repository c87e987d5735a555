#include "mesh/parallel/Partition.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/SplitVertices.hpp"
#include "mesh/parallel/detail/Broadcast.hpp"

namespace asperity::mesh
{
template <int Dim>
void broadcast(GlobalMesh<Dim>& mesh, Communicator const& communicator)
{
  const detail::Broadcast from_root(communicator);
  from_root.rows(mesh.vertices);
  Teuchos::broadcast(communicator, 0, Dim, mesh.period.data());
  from_root.rows(mesh.cells);
  from_root.values(mesh.cell_regions);
  from_root.texts(mesh.region_names);
  auto names = boundaryNames(mesh);
  from_root.texts(names);
  std::map<std::string, std::vector<typename GlobalMesh<Dim>::Facet>> boundaries;
  for (auto const& name : names) {
    auto& facets = boundaries[name] = std::move(mesh.boundaries[name]);
    from_root.rows(facets);
  }
  mesh.boundaries = std::move(boundaries);
  auto splits = asRows(mesh.splits);
  from_root.rows(splits);
  mesh.splits = fromRows(splits);
  from_root.texts(mesh.faults);
}

template void broadcast(GlobalMesh<2>&, Communicator const&);
template void broadcast(GlobalMesh<3>&, Communicator const&);
} // namespace asperity::mesh
