#include "fem/BoundaryMeasure.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/faults/Facing.hpp"

#include <cmath>
#include <map>

namespace asperity::fem
{
template <int Dim>
std::vector<NodalMeasure<Dim>> boundaryMeasure(Mesh<Dim> const& mesh, std::string const& boundary,
                                               Communicator const& communicator)
{
  std::map<int, NodalMeasure<Dim>> nodes;
  for (auto const& facet : mesh::boundaryFacets(mesh, boundary)) {
    auto const corners = mesh::corners(mesh, facet);
    auto const normal = mesh::areaNormal(corners);
    const double measure = mesh::facetMeasure(corners);
    for (int node : facet) {
      if (node < mesh.num_owned) {
        auto& sum = nodes[node];
        sum.weight += measure / Dim;
        for (int i = 0; i < Dim; ++i) {
          sum.normal[i] += normal[i];
        }
      }
    }
  }
  std::vector<NodalMeasure<Dim>> result;
  for (auto& [node, sum] : nodes) {
    sum.node = node;
    const double size = std::sqrt(mesh::dot<Dim>(sum.normal, sum.normal));
    for (double& x : sum.normal) {
      x /= size;
    }
    result.push_back(sum);
  }
  const auto num_nodes = sumOverRanks(static_cast<std::int64_t>(result.size()), communicator);
  ASPERITY_REQUIRE(num_nodes > 0, "Boundary '" << boundary << "' of the mesh has no facets.");
  return result;
}

template <int Dim>
NormalIntegral integrateNormal(Mesh<Dim> const& mesh, std::vector<std::string> const& boundaries,
                               Communicator const& communicator)
{
  auto const facing = mesh::facingOf(mesh, boundaries, communicator);
  return {facing.normal, facing.measure};
}

template NormalIntegral integrateNormal(Mesh<2> const&, std::vector<std::string> const&,
                                        Communicator const&);
template NormalIntegral integrateNormal(Mesh<3> const&, std::vector<std::string> const&,
                                        Communicator const&);
template std::vector<NodalMeasure<2>> boundaryMeasure(Mesh<2> const&, std::string const&,
                                                      Communicator const&);
template std::vector<NodalMeasure<3>> boundaryMeasure(Mesh<3> const&, std::string const&,
                                                      Communicator const&);
} // namespace asperity::fem
