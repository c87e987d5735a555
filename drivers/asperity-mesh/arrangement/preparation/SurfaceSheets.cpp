#include "arrangement/preparation/SurfaceSheets.hpp"

#include "arrangement/complex/Patches.hpp"

#include "base/DisjointSets.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace
{
// The edges at which the same parts meet, and how well each pair of parts continues each other.
struct Branch
{
  struct Pair
  {
    double cosine = 0; // of the angle between the parts at the line, integrated along it [m]
    int first, second; // positions in the list of parts
  };
  std::map<std::pair<int, int>, double> cosines;
  std::vector<int> parts; // ascending; a part that meets itself is listed twice

  std::vector<Pair> straightest() const
  {
    std::vector<Pair> pairs;
    for (auto const& [pair, cosine] : cosines) {
      pairs.push_back({cosine, pair.first, pair.second});
    }
    std::sort(pairs.begin(), pairs.end(),
              [](Pair const& a, Pair const& b) { return a.cosine < b.cosine; });
    return pairs;
  }
};

std::map<std::vector<int>, Branch> branchesOf(Complex const& complex, Patches const& patches,
                                              TrianglesAtEdges const& at_edges)
{
  std::map<std::vector<int>, Branch> branches;
  for (auto const& [edge, triangles] : at_edges) {
    if (triangles.size() <= 2) {
      continue;
    }
    std::vector<std::pair<int, Point<3>>> around; // part, direction into it
    for (int i : triangles) {
      around.emplace_back(patches.patch_of_triangle[i],
                          inward(complex.points, edge, complex.triangles[i]));
    }
    std::sort(around.begin(), around.end());
    std::vector<int> parts;
    for (auto const& [part, direction] : around) {
      parts.push_back(part);
    }
    auto& branch = branches[parts];
    branch.parts = parts;
    const double length = mesh::distance<3>(complex.points[edge[0]], complex.points[edge[1]]);
    for (int i = 0; i < static_cast<int>(around.size()); ++i) {
      for (int j = i + 1; j < static_cast<int>(around.size()); ++j) {
        branch.cosines[{i, j}] += length * mesh::dot<3>(around[i].second, around[j].second);
      }
    }
  }
  return branches;
}

TriangleSurface partOf(Complex const& complex, std::vector<bool> const& is_part)
{
  auto part = complex;
  keepTriangles(part, is_part);
  return {std::move(part.points), std::move(part.triangles)};
}
} // namespace

std::vector<TriangleSurface> sheetsOf(TriangleSurface const& surface)
{
  const auto at_edges = trianglesAtEdges(surface.triangles);
  const Complex complex = {surface.points, surface.triangles,
                           std::vector<int>(surface.triangles.size(), 0)};
  const auto patches = findPatches(complex);
  const auto branches = branchesOf(complex, patches, at_edges);
  if (branches.empty()) {
    return {surface};
  }
  DisjointSets sheets(patches.list.size());
  for (auto const& [parts, branch] : branches) {
    std::vector<bool> has_partner(parts.size(), false);
    for (auto const& pair : branch.straightest()) {
      if (!has_partner[pair.first] && !has_partner[pair.second]) {
        has_partner[pair.first] = has_partner[pair.second] = true;
        sheets.join(parts[pair.first], parts[pair.second]);
      }
    }
  }
  std::map<std::size_t, double> areas;
  for (std::size_t p = 0; p < patches.list.size(); ++p) {
    areas[sheets.find(p)] += patches.list[p].area;
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (auto const& [sheet, area] : areas) {
    order.emplace_back(-area, sheet);
  }
  std::sort(order.begin(), order.end());
  std::vector<TriangleSurface> result;
  for (auto const& [area, sheet] : order) {
    std::vector<bool> is_part;
    for (int patch : patches.patch_of_triangle) {
      is_part.push_back(sheets.find(patch) == sheet);
    }
    result.push_back(partOf(complex, is_part));
  }
  return result;
}
} // namespace asperity::geometry
