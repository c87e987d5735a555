#include "arrangement/complex/TriangleTree.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace asperity::geometry
{
namespace
{
using Corners = std::array<Point<3>, 3>;

Point<3> sum(Point<3> const& a, double s, Point<3> const& b)
{
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

Point<3> nearestOnSegment(Point<3> const& a, Point<3> const& b, Point<3> const& place)
{
  const auto along = mesh::difference<3>(b, a);
  const double square = mesh::dot<3>(along, along);
  const double s = square > 0 ? mesh::dot<3>(mesh::difference<3>(place, a), along) / square : 0;
  return sum(a, std::clamp(s, 0., 1.), along);
}

// The orthogonal projection onto the triangle if it lies inside, else the nearest point of a side.
Point<3> nearestOnTriangle(Corners const& corners, Point<3> const& place)
{
  const auto u = mesh::difference<3>(corners[1], corners[0]);
  const auto v = mesh::difference<3>(corners[2], corners[0]);
  const auto w = mesh::difference<3>(place, corners[0]);
  const double uu = mesh::dot<3>(u, u), uv = mesh::dot<3>(u, v), vv = mesh::dot<3>(v, v);
  const double uw = mesh::dot<3>(u, w), vw = mesh::dot<3>(v, w);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 0) {
    const double s = (vv * uw - uv * vw) / determinant, t = (uu * vw - uv * uw) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1) {
      return sum(sum(corners[0], s, u), t, v);
    }
  }
  Point<3> best{};
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const auto point = nearestOnSegment(corners[k], corners[(k + 1) % 3], place);
    const double distance = mesh::distance<3>(point, place);
    if (distance < smallest) {
      smallest = distance;
      best = point;
    }
  }
  return best;
}

// Moeller and Trumbore: from + t (to - from) = corner 0 + r u + s v with t in [0, 1].
bool crosses(Corners const& corners, Point<3> const& from, Point<3> const& to)
{
  const auto u = mesh::difference<3>(corners[1], corners[0]);
  const auto v = mesh::difference<3>(corners[2], corners[0]);
  const auto along = mesh::difference<3>(to, from);
  const auto normal = mesh::cross(along, v);
  const double determinant = mesh::dot<3>(u, normal);
  if (determinant == 0) {
    return false;
  }
  const auto w = mesh::difference<3>(from, corners[0]);
  const auto q = mesh::cross(w, u);
  const double r = mesh::dot<3>(w, normal) / determinant;
  const double s = mesh::dot<3>(along, q) / determinant;
  const double t = mesh::dot<3>(v, q) / determinant;
  return r >= 0 && s >= 0 && r + s <= 1 && t >= 0 && t <= 1;
}

template <class Box>
double distanceTo(Box const& box, Point<3> const& place)
{
  double square = 0;
  for (int d = 0; d < 3; ++d) {
    const double outside = std::max({box.low[d] - place[d], 0., place[d] - box.high[d]});
    square += outside * outside;
  }
  return std::sqrt(square);
}
} // namespace

TriangleTree::TriangleTree(std::vector<Point<3>> const& points,
                           std::vector<Triangle> const& triangles)
    : order_(triangles.size())
{
  for (auto const& triangle : triangles) {
    corners_.push_back({points[triangle[0]], points[triangle[1]], points[triangle[2]]});
  }
  std::iota(order_.begin(), order_.end(), 0);
  if (!triangles.empty()) {
    build(0, static_cast<int>(triangles.size()));
  }
}

int TriangleTree::build(int first, int last)
{
  constexpr int largest_leaf = 4;
  Box box{corners_[order_[first]][0], corners_[order_[first]][0]};
  for (int i = first; i < last; ++i) {
    for (auto const& corner : corners_[order_[i]]) {
      for (int d = 0; d < 3; ++d) {
        box.low[d] = std::min(box.low[d], corner[d]);
        box.high[d] = std::max(box.high[d], corner[d]);
      }
    }
  }
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back({box, first, last});
  if (last - first > largest_leaf) {
    int axis = 0;
    for (int d = 1; d < 3; ++d) {
      axis = box.high[d] - box.low[d] > box.high[axis] - box.low[axis] ? d : axis;
    }
    const auto height = [&](int i) {
      return corners_[i][0][axis] + corners_[i][1][axis] + corners_[i][2][axis];
    };
    const int middle = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int i, int j) { return height(i) < height(j); });
    const int left = build(first, middle), right = build(middle, last);
    nodes_[number].left = left;
    nodes_[number].right = right;
  }
  return number;
}

void TriangleTree::search(int number, Point<3> const& place, Filter const& filter,
                          Nearest& nearest) const
{
  auto const& node = nodes_[number];
  if (node.left < 0) {
    for (int i = node.first; i < node.last; ++i) {
      const auto point = nearestOnTriangle(corners_[order_[i]], place);
      const double distance = mesh::distance<3>(point, place);
      if (distance < nearest.distance && (!filter || filter(order_[i]))) {
        nearest = {order_[i], point, distance};
      }
    }
    return;
  }
  int near = node.left, far = node.right;
  double to_near = distanceTo(nodes_[near].box, place), to_far = distanceTo(nodes_[far].box, place);
  if (to_far < to_near) {
    std::swap(near, far);
    std::swap(to_near, to_far);
  }
  if (to_near < nearest.distance) {
    search(near, place, filter, nearest);
  }
  if (to_far < nearest.distance) {
    search(far, place, filter, nearest);
  }
}

double TriangleTree::distance(int triangle, Point<3> const& place) const
{
  return mesh::distance<3>(nearestOnTriangle(corners_[triangle], place), place);
}

bool TriangleTree::isCrossedBy(Point<3> const& from, Point<3> const& to) const
{
  std::vector<int> stack;
  if (!nodes_.empty()) {
    stack.push_back(0);
  }
  while (!stack.empty()) {
    auto const& node = nodes_[stack.back()];
    stack.pop_back();
    bool is_apart = false;
    for (int d = 0; d < 3; ++d) {
      is_apart = is_apart || std::max(from[d], to[d]) < node.box.low[d] ||
                 std::min(from[d], to[d]) > node.box.high[d];
    }
    if (is_apart) {
      continue;
    }
    if (node.left >= 0) {
      stack.insert(stack.end(), {node.left, node.right});
      continue;
    }
    for (int i = node.first; i < node.last; ++i) {
      if (crosses(corners_[order_[i]], from, to)) {
        return true;
      }
    }
  }
  return false;
}

TriangleTree::Nearest TriangleTree::nearest(Point<3> const& place, double bound,
                                            Filter const& filter) const
{
  Nearest result;
  result.distance = bound;
  if (!nodes_.empty() && distanceTo(nodes_.front().box, place) < bound) {
    search(0, place, filter, result);
  }
  return result;
}
} // namespace asperity::geometry
