#include "fem/BoundaryNodes.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <cmath>
#include <map>

namespace asperity::fem
{
namespace
{
template <int Dim>
struct Accumulated
{
  double weight = 0;
  Point<Dim> normal{};
};

template <int Dim>
std::string namesOf(Mesh<Dim> const& mesh)
{
  std::string names;
  for (auto const& entry : mesh.boundaries) {
    names += (names.empty() ? "'" : ", '") + entry.first + "'";
  }
  return names.empty() ? "none" : names;
}
} // namespace

template <int Dim>
BoundaryNodes<Dim> boundaryNodes(Mesh<Dim> const& mesh, std::string const& boundary,
                                 Communicator const& communicator)
{
  auto const facets = mesh.boundaries.find(boundary);
  ASPERITY_REQUIRE(facets != mesh.boundaries.end(), "The mesh has no boundary '"
                                                      << boundary << "'. Its boundaries are "
                                                      << namesOf(mesh) << ".");
  std::map<int, Accumulated<Dim>> nodes;
  for (auto const& facet : facets->second) {
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
  BoundaryNodes<Dim> result;
  for (auto const& [node, sum] : nodes) {
    const double size = std::sqrt(mesh::dot<Dim>(sum.normal, sum.normal));
    Point<Dim> normal = sum.normal;
    for (double& x : normal) {
      x /= size;
    }
    result.nodes.push_back(node);
    result.weights.push_back(sum.weight);
    result.normals.push_back(normal);
  }
  const int mine = static_cast<int>(result.nodes.size());
  int all = 0;
  Teuchos::reduceAll(communicator, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  ASPERITY_REQUIRE(all > 0, "Boundary '" << boundary << "' of the mesh has no facets.");
  return result;
}

template struct BoundaryNodes<2>;
template struct BoundaryNodes<3>;
template BoundaryNodes<2> boundaryNodes<2>(Mesh<2> const&, std::string const&, Communicator const&);
template BoundaryNodes<3> boundaryNodes<3>(Mesh<3> const&, std::string const&, Communicator const&);
} // namespace asperity::fem
