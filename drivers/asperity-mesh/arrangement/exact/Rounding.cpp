#include "arrangement/exact/Rounding.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <vector>

namespace asperity::geometry
{
namespace
{
// Removes triangles that have two equal points, and copies of triangles.
void removeRepeated(Complex& complex, std::vector<bool> is_kept)
{
  std::set<Triangle> known;
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    auto t = complex.triangles[i];
    std::sort(t.begin(), t.end());
    is_kept[i] = is_kept[i] && t[0] != t[1] && t[1] != t[2] && known.insert(t).second;
  }
  keepTriangles(complex, is_kept);
}

bool weld(Complex& complex, double tolerance)
{
  std::vector<int> root(complex.points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[v] != v) {
      v = root[v] = root[root[v]];
    }
    return v;
  };
  bool is_changed = false;
  for (auto const& t : complex.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int a = find(t[k]), b = find(t[(k + 1) % 3]);
      if (a != b &&
          mesh::distance<3>(complex.points[t[k]], complex.points[t[(k + 1) % 3]]) < tolerance) {
        root[std::max(a, b)] = std::min(a, b);
        is_changed = true;
      }
    }
  }
  for (auto& t : complex.triangles) {
    for (int& v : t) {
      v = find(v);
    }
  }
  removeRepeated(complex, std::vector<bool>(complex.triangles.size(), true));
  return is_changed;
}

// The longest edge of a triangle without height: the number of its first corner; or -1.
int baseOfCap(Complex const& complex, Triangle const& t, double tolerance)
{
  int base = 0;
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const double length = mesh::distance<3>(complex.points[t[k]], complex.points[t[(k + 1) % 3]]);
    if (length > longest) {
      longest = length;
      base = k;
    }
  }
  return 2 * areaOf(complex.points, t) > tolerance * longest ? -1 : base;
}

bool divideAtCaps(Complex& complex, double tolerance)
{
  const auto at_edges = trianglesAtEdges(complex.triangles);
  const std::size_t number = complex.triangles.size();
  std::vector<bool> is_kept(number, true), is_busy(number, false);
  bool is_changed = false;
  for (std::size_t i = 0; i < number; ++i) {
    const auto cap = complex.triangles[i];
    const int base = baseOfCap(complex, cap, tolerance);
    if (base < 0 || is_busy[i]) {
      continue;
    }
    const int middle = cap[(base + 2) % 3];
    const auto edge = edgeOf(cap, base);
    auto const& around = at_edges.at(edge);
    if (std::any_of(around.begin(), around.end(), [&](int j) { return is_busy[j]; })) {
      continue;
    }
    for (int j : around) {
      is_busy[j] = true;
      const auto t = complex.triangles[j];
      int k = 0;
      while (edgeOf(t, k) != edge) {
        ++k;
      }
      const int apex = t[(k + 2) % 3];
      if (apex == middle) {
        is_kept[j] = false;
        continue;
      }
      complex.triangles[j] = {t[k], middle, apex};
      complex.triangles.push_back({middle, t[(k + 1) % 3], apex});
      complex.surfaces.push_back(complex.surfaces[j]);
      is_kept.push_back(true);
    }
    for (int end : edge) { // their triangles are changed in the next pass
      for (int j : at_edges.at(edgeOf(end, middle))) {
        is_busy[j] = true;
      }
    }
    is_changed = true;
  }
  removeRepeated(complex, is_kept);
  return is_changed;
}
} // namespace

void removeRounding(Complex& complex, double tolerance)
{
  constexpr int most_passes = 20;
  weld(complex, tolerance);
  for (int pass = 0; pass < most_passes && divideAtCaps(complex, tolerance); ++pass) {
    weld(complex, tolerance);
  }
}
} // namespace asperity::geometry
