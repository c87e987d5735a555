#include "fem/constraints/detail/ConditionNodes.hpp"

#include "fem/constraints/detail/NodalBasis.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
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
      auto const outward = mesh::areaNormal(mesh::corners(mesh, facet));
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

void turnIntoWalls(NodalVectors const& walls, std::map<int, std::vector<double>>& normals)
{
  constexpr double nearly = 0.1; // sine of the angle to a wall's plane
  for (auto& [node, normal] : normals) {
    auto const at_node = walls.find(node);
    if (at_node == walls.end()) {
      continue;
    }
    const double size = std::sqrt(dot(normal, normal));
    NodalBasis planes;
    for (auto const& wall : at_node->second) {
      Terms none;
      if (std::abs(dot(normal, wall)) < nearly * size) {
        planes.add(wall, none);
      }
    }
    for (auto const& across : planes.vectors()) {
      const double rest = dot(normal, across);
      for (std::size_t c = 0; c < normal.size(); ++c) {
        normal[c] -= rest * across[c];
      }
    }
  }
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
