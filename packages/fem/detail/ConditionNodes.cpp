#include "fem/detail/ConditionNodes.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <iterator>

namespace asperity::fem::detail
{
template <int Dim>
std::map<int, std::vector<double>> inwardNormals(Mesh<Dim> const& mesh, int components,
                                                 std::vector<std::string> const& boundaries)
{
  std::map<int, std::vector<double>> normals;
  for (auto const& name : boundaries) {
    for (auto const& facet : mesh.boundaries.at(name)) {
      auto const outward = mesh::areaNormal(mesh::corners<Dim>(mesh.vertices, facet));
      for (int node : facet) {
        if (node < mesh.num_owned) {
          auto& normal = normals.try_emplace(node, components, 0.).first->second;
          for (int c = 0; c < std::min(components, Dim); ++c) {
            normal[c] -= outward[c];
          }
        }
      }
    }
  }
  return normals;
}

template <int Dim>
std::vector<int> ownedNodes(Mesh<Dim> const& mesh, std::string const& boundary)
{
  std::vector<int> nodes;
  for (auto const& facet : mesh.boundaries.at(boundary)) {
    std::copy_if(facet.begin(), facet.end(), std::back_inserter(nodes),
                 [&mesh](int node) { return node < mesh.num_owned; });
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

template std::map<int, std::vector<double>> inwardNormals(Mesh<2> const&, int,
                                                          std::vector<std::string> const&);
template std::map<int, std::vector<double>> inwardNormals(Mesh<3> const&, int,
                                                          std::vector<std::string> const&);
template std::vector<int> ownedNodes(Mesh<2> const&, std::string const&);
template std::vector<int> ownedNodes(Mesh<3> const&, std::string const&);
} // namespace asperity::fem::detail
