#include "meshing/CellAngles.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::geometry
{
double smallestDihedral(std::array<Point<3>, 4> const& x)
{
  constexpr int edges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                               {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
  double largest_cosine = -1;
  for (auto const& [i, j, k, l] : edges) {
    const auto along = mesh::difference<3>(x[j], x[i]);
    const auto u = mesh::cross(along, mesh::difference<3>(x[k], x[i]));
    const auto v = mesh::cross(along, mesh::difference<3>(x[l], x[i]));
    largest_cosine = std::max(largest_cosine, mesh::dot<3>(u, v) /
                                                std::sqrt(mesh::dot<3>(u, u) * mesh::dot<3>(v, v)));
  }
  return std::acos(std::min(largest_cosine, 1.)) * 180 / std::acos(-1.);
}

double orientedAngle(std::array<Point<3>, 4> const& x)
{
  const double volume =
    mesh::dot<3>(mesh::cross(mesh::difference<3>(x[1], x[0]), mesh::difference<3>(x[2], x[0])),
                 mesh::difference<3>(x[3], x[0]));
  return volume > 0 ? smallestDihedral(x) : -1;
}
} // namespace asperity::geometry
