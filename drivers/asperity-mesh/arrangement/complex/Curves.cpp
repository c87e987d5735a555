#include "arrangement/complex/Curves.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace
{
class Walk
{
public:
  explicit Walk(Complex const& complex) : complex_(complex)
  {
    for (auto const& [edge, triangles] : trianglesAtEdges(complex.triangles)) {
      std::vector<int> surfaces;
      for (int i : triangles) {
        surfaces.push_back(complex.surfaces[i]);
      }
      std::sort(surfaces.begin(), surfaces.end());
      if (surfaces.size() != 2 || surfaces[0] != surfaces[1]) {
        edges_[edge[0]].emplace(edge[1], surfaces);
        edges_[edge[1]].emplace(edge[0], surfaces);
      }
    }
    for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
      for (int v : complex.triangles[i]) {
        const auto found = edges_.find(v);
        if (found != edges_.end()) {
          surfaces_at_[v].insert(complex.surfaces[i]);
        }
      }
    }
  }

  std::vector<Curve> run()
  {
    for (auto const& [v, ends] : edges_) {
      if (isCorner(v)) {
        startAt(v);
      }
    }
    for (auto const& [v, ends] : edges_) { // closed curves have no end to begin with
      startAt(v);
    }
    return curves_;
  }

private:
  bool isCorner(int v) const
  {
    auto const& ends = edges_.at(v);
    if (ends.size() != 2 || ends.begin()->second != ends.rbegin()->second) {
      return true;
    }
    auto const& surfaces = ends.begin()->second;
    if (std::set<int>(surfaces.begin(), surfaces.end()) != surfaces_at_.at(v)) {
      return true; // another surface touches the curve here
    }
    auto const& x = complex_.points;
    const auto u = mesh::difference<3>(x[v], x[ends.begin()->first]);
    const auto w = mesh::difference<3>(x[ends.rbegin()->first], x[v]);
    return mesh::dot<3>(u, w) < sharp_turn * std::sqrt(mesh::dot<3>(u, u) * mesh::dot<3>(w, w));
  }

  void startAt(int start)
  {
    for (auto const& [next, surfaces] : edges_.at(start)) {
      if (is_used_.count(edgeOf(start, next)) > 0) {
        continue;
      }
      Curve curve{{start}, surfaces};
      int here = start, there = next;
      is_used_.insert(edgeOf(here, there));
      curve.points.push_back(there);
      while (there != start && !isCorner(there)) {
        auto const& ends = edges_.at(there);
        const int after = ends.begin()->first == here ? ends.rbegin()->first : ends.begin()->first;
        here = there;
        there = after;
        is_used_.insert(edgeOf(here, there));
        curve.points.push_back(there);
      }
      curves_.push_back(std::move(curve));
    }
  }

  Complex const& complex_;
  std::map<int, std::map<int, std::vector<int>>> edges_; // surfaces by both ends
  std::map<int, std::set<int>> surfaces_at_;
  std::set<Edge> is_used_;
  std::vector<Curve> curves_;
};
} // namespace

std::vector<Curve> findCurves(Complex const& complex) { return Walk(complex).run(); }

double lengthOf(Complex const& complex, Curve const& curve)
{
  double length = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    length +=
      mesh::distance<3>(complex.points[curve.points[i - 1]], complex.points[curve.points[i]]);
  }
  return length;
}
} // namespace asperity::geometry
