#pragma once

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <array>

// How one simplex is divided: corners are numbered 0 .. Dim, the midpoint of its edge k follows as
// Dim + 1 + k.
namespace asperity::refinement::detail
{
template <int Dim>
struct RedRule;

// Four triangles similar to the first one, oriented as it is.
template <>
struct RedRule<2>
{
  static constexpr int edges[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  static constexpr int children[4][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}, {3, 5, 4}};
};

// Bey, Tetrahedral grid refinement, Computing 55 (1995): the order of the corners says which
// diagonal of the octahedron inside is an edge, that between the midpoints of 0-2 and 1-3, and the
// children inherit an order. Whatever the first order is, all descendants of a tetrahedron have at
// most three shapes. Children may be negatively oriented.
template <>
struct RedRule<3>
{
  static constexpr int edges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  static constexpr int children[8][4] = {{0, 4, 5, 6}, {4, 1, 7, 8}, {5, 7, 2, 9}, {6, 8, 9, 3},
                                         {4, 5, 6, 8}, {4, 5, 7, 8}, {5, 6, 8, 9}, {5, 7, 8, 9}};
};

// Facets, the corners and midpoints numbered alike; the children are oriented as the facet is.
template <int Dim>
struct FacetRule;

template <>
struct FacetRule<2>
{
  static constexpr int edges[1][2] = {{0, 1}};
  static constexpr int children[2][2] = {{0, 2}, {2, 1}};
};

template <>
struct FacetRule<3>
{
  static constexpr int edges[3][2] = {{0, 1}, {1, 2}, {2, 0}};
  static constexpr int children[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
};

// The order of the corners with which the division of a tetrahedron starts. Of the corners sorted
// by their global ids, s0 .. s3, and of the orders s0 s1 s2 s3, s0 s1 s3 s2 and s0 s2 s1 s3 it is
// the first one whose diagonal inside is, up to rounding, the shortest one, so that all
// ranks choose the same. The cubes of six tetrahedra of BoxMesh are divided into such cubes of half
// the size.
inline std::array<int, 4> firstOrder(std::array<int, 4> const& sorted,
                                     std::array<Point<3>, 4> const& corners)
{
  constexpr int orders[3][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 1, 3}};
  std::array<double, 3> lengths;
  for (int o = 0; o < 3; ++o) {
    auto const& i = orders[o];
    const std::array<Point<3>, 2> one{corners[i[0]], corners[i[2]]};
    const std::array<Point<3>, 2> other{corners[i[1]], corners[i[3]]};
    lengths[o] = mesh::distance<3>(mesh::centroid(one), mesh::centroid(other));
  }
  const double shortest = *std::min_element(lengths.begin(), lengths.end());
  int chosen = 0;
  while (lengths[chosen] > (1.0 + 1e-6) * shortest) {
    ++chosen;
  }
  std::array<int, 4> result;
  for (int i = 0; i < 4; ++i) {
    result[i] = sorted[orders[chosen][i]];
  }
  return result;
}
} // namespace asperity::refinement::detail
