#include "arrangement/complex/Patches.hpp"

#include <cstddef>
#include <vector>

namespace asperity::geometry
{
namespace
{
Patch describe(Complex const& complex, TrianglesAtEdges const& at_edges,
               std::vector<int> const& triangles)
{
  Patch patch;
  patch.surface = complex.surfaces[triangles.front()];
  double largest = 0;
  for (int i : triangles) {
    auto const& triangle = complex.triangles[i];
    const double area = areaOf(complex.points, triangle);
    patch.area += area;
    if (area > largest) {
      largest = area;
      patch.largest = i;
    }
    for (int k = 0; k < 3; ++k) {
      auto const& around = at_edges.at(edgeOf(triangle, k));
      patch.has_free_border = patch.has_free_border || around.size() == 1;
      for (int j : around) {
        patch.meets_others = patch.meets_others || complex.surfaces[j] != patch.surface;
      }
    }
  }
  return patch;
}
} // namespace

Patches findPatches(Complex const& complex)
{
  const auto at_edges = trianglesAtEdges(complex.triangles);
  Patches patches;
  patches.patch_of_triangle.assign(complex.triangles.size(), -1);
  for (std::size_t start = 0; start < complex.triangles.size(); ++start) {
    if (patches.patch_of_triangle[start] >= 0) {
      continue;
    }
    const auto number = static_cast<int>(patches.list.size());
    std::vector<int> members = {static_cast<int>(start)};
    patches.patch_of_triangle[start] = number;
    for (std::size_t next = 0; next < members.size(); ++next) {
      const int i = members[next];
      for (int k = 0; k < 3; ++k) {
        auto const& around = at_edges.at(edgeOf(complex.triangles[i], k));
        for (int j : around) {
          if (around.size() == 2 && complex.surfaces[j] == complex.surfaces[i] &&
              patches.patch_of_triangle[j] < 0) {
            patches.patch_of_triangle[j] = number;
            members.push_back(j);
          }
        }
      }
    }
    patches.list.push_back(describe(complex, at_edges, members));
  }
  return patches;
}
} // namespace asperity::geometry
