#include "surfaces/Weld.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace asperity::geometry
{
namespace
{
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<int, 3>>;

// For each point the first one that is equal.
std::vector<int> firstOfEqual(Points const& points)
{
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int i) -> auto const& { return points[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return at(a) < at(b) || (at(a) == at(b) && a < b); });
  int representative = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || at(order[i]) != at(representative)) {
      representative = order[i];
    }
    first[static_cast<std::size_t>(order[i])] = representative;
  }
  return first;
}

// Whether the area exceeds rounding errors, compared with the square of the longest edge.
bool hasArea(std::array<double, 3> const& a, std::array<double, 3> const& b,
             std::array<double, 3> const& c)
{
  constexpr double least = 1e-12;
  const auto difference = [](auto const& p, auto const& q) {
    return std::array<double, 3>{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  };
  const auto square = [](auto const& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; };
  const auto u = difference(a, b), v = difference(a, c);
  const std::array<double, 3> normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                        u[0] * v[1] - u[1] * v[0]};
  const double longest = std::max({square(u), square(v), square(difference(b, c))});
  return std::sqrt(square(normal)) > least * longest;
}

std::size_t dropWithoutArea(Points const& points, Triangles& triangles)
{
  const auto at = [&](int i) -> auto const& { return points[static_cast<std::size_t>(i)]; };
  const auto end = std::remove_if(triangles.begin(), triangles.end(), [&](auto const& t) {
    return !hasArea(at(t[0]), at(t[1]), at(t[2]));
  });
  const auto count = static_cast<std::size_t>(triangles.end() - end);
  triangles.erase(end, triangles.end());
  return count;
}

std::size_t dropRepeated(Triangles& triangles)
{
  const auto key = [&](int i) {
    auto corners = triangles[static_cast<std::size_t>(i)];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::vector<int> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto one = key(a), other = key(b);
    return one < other || (one == other && a < b);
  });
  std::size_t count = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (key(order[i]) == key(order[i - 1])) {
      std::swap(order[i], order[i - 1]); // so that the next is compared with the one that stays
      order[i - 1] = -order[i - 1] - 1;
      ++count;
    }
  }
  if (count == 0) {
    return 0;
  }
  std::vector<bool> is_dropped(triangles.size(), false);
  for (const int i : order) {
    if (i < 0) {
      is_dropped[static_cast<std::size_t>(-i - 1)] = true;
    }
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!is_dropped[t]) {
      triangles[kept++] = triangles[t];
    }
  }
  triangles.resize(kept);
  return count;
}

// In the order in which the triangles use them.
void keepUsed(Points& points, Triangles& triangles)
{
  std::vector<int> number(points.size(), -1);
  Points used;
  for (auto& triangle : triangles) {
    for (int& vertex : triangle) {
      int& n = number[static_cast<std::size_t>(vertex)];
      if (n < 0) {
        n = static_cast<int>(used.size());
        used.push_back(points[static_cast<std::size_t>(vertex)]);
      }
      vertex = n;
    }
  }
  used.shrink_to_fit();
  points = std::move(used);
}

std::string triangleCount(std::size_t count)
{
  return std::to_string(count) + (count == 1 ? " triangle" : " triangles");
}
} // namespace

TriangleSurface welded(TriangleSurface&& surface, std::string const& where,
                       RemarkSink const& remark)
{
  ASPERITY_REQUIRE(surface.points.size() < std::numeric_limits<int>::max() &&
                     surface.triangles.size() < std::numeric_limits<int>::max(),
                   where << " has more than 2^31 points or triangles.");
  TriangleSurface result = std::move(surface);
  {
    const auto first = firstOfEqual(result.points);
    for (auto& triangle : result.triangles) {
      for (int& vertex : triangle) {
        vertex = first[static_cast<std::size_t>(vertex)];
      }
    }
  }
  const std::size_t all = result.triangles.size();
  if (const auto count = dropWithoutArea(result.points, result.triangles)) {
    remark(where + ": " + triangleCount(count) + " of " + std::to_string(all) +
           " without area left out.");
  }
  if (const auto count = dropRepeated(result.triangles)) {
    remark(where + ": " + triangleCount(count) + " of " + std::to_string(all) +
           " left out, because the same three corners have a triangle already.");
  }
  ASPERITY_REQUIRE(!result.triangles.empty(),
                   where << " has no triangle" << (all > 0 ? " with an area." : "."));
  keepUsed(result.points, result.triangles);
  return result;
}
} // namespace asperity::geometry
