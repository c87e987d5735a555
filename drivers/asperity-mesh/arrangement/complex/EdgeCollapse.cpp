#include "arrangement/complex/EdgeCollapse.hpp"

#include "arrangement/complex/Complex.hpp"
#include "arrangement/complex/Curves.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace asperity::geometry
{
namespace
{
double norm(Point<3> const& v) { return std::sqrt(mesh::dot<3>(v, v)); }

enum class Place
{
  patch,
  curve,
  corner
};

// The surfaces and curves at a point.
struct Star
{
  Place place = Place::patch;
  std::set<int> surfaces;
  std::map<int, std::vector<int>> curves; // (other end of an edge of curves, surfaces at it)
};

class Contraction
{
public:
  Contraction(Complex& complex, Model const& model, Shortest const& shortest)
      : complex_(complex)
      , model_(model)
      , shortest_(shortest)
      , is_there_(complex.triangles.size(), true)
      , around_(complex.points.size())
  {
    for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
      for (int v : complex.triangles[i]) {
        around_[v].push_back(static_cast<int>(i));
      }
    }
  }

  int run()
  {
    constexpr int most_passes = 20;
    int corners = 0;
    bool is_changed = true;
    for (int pass = 0; is_changed && pass < most_passes; ++pass) {
      is_changed = false;
      for (auto const& [length, edge] : shortEdges()) {
        if (!hasEdge(edge)) {
          continue;
        }
        const auto first = star(edge[0]), second = star(edge[1]);
        const bool both = first.place == Place::corner && second.place == Place::corner;
        const double limit = shortest_(complex_.points[edge[0]]);
        const bool is_done = contract(edge[0], edge[1], first, second, limit) ||
                             contract(edge[1], edge[0], second, first, limit);
        corners += is_done && both ? 1 : 0;
        is_changed = is_changed || is_done;
      }
    }
    keepTriangles(complex_, is_there_);
    return corners;
  }

private:
  std::vector<std::pair<double, Edge>> shortEdges() const
  {
    std::set<std::pair<double, Edge>> edges;
    for (std::size_t i = 0; i < is_there_.size(); ++i) {
      for (int k = 0; is_there_[i] && k < 3; ++k) {
        const auto edge = edgeOf(complex_.triangles[i], k);
        const double length = mesh::distance<3>(complex_.points[edge[0]], complex_.points[edge[1]]);
        if (length < shortest_(complex_.points[edge[0]])) {
          edges.emplace(length, edge);
        }
      }
    }
    return {edges.begin(), edges.end()};
  }

  bool hasEdge(Edge const& edge) const { return !trianglesAt(edge).empty(); }

  std::vector<int> trianglesAt(Edge const& edge) const
  {
    std::vector<int> found;
    for (int i : around_[edge[0]]) {
      auto const& t = complex_.triangles[i];
      if (std::count(t.begin(), t.end(), edge[1]) > 0) {
        found.push_back(i);
      }
    }
    return found;
  }

  std::set<int> neighbours(int v) const
  {
    std::set<int> found;
    for (int i : around_[v]) {
      found.insert(complex_.triangles[i].begin(), complex_.triangles[i].end());
    }
    found.erase(v);
    return found;
  }

  Star star(int v) const
  {
    Star star;
    std::map<int, std::vector<int>> surfaces_at; // by the other end of an edge
    for (int i : around_[v]) {
      star.surfaces.insert(complex_.surfaces[i]);
      for (int w : complex_.triangles[i]) {
        if (w != v) {
          surfaces_at[w].push_back(complex_.surfaces[i]);
        }
      }
    }
    for (auto& [w, surfaces] : surfaces_at) {
      if (surfaces.size() != 2 || surfaces[0] != surfaces[1]) {
        std::sort(surfaces.begin(), surfaces.end());
        star.curves.emplace(w, surfaces);
      }
    }
    star.place = placeOf(v, star);
    return star;
  }

  Place placeOf(int v, Star const& star) const
  {
    if (star.curves.empty()) {
      return star.surfaces.size() == 1 ? Place::patch : Place::corner;
    }
    auto const& [first, surfaces] = *star.curves.begin();
    auto const& [last, others] = *star.curves.rbegin();
    const std::set<int> of_curve(surfaces.begin(), surfaces.end());
    if (star.curves.size() != 2 || surfaces != others || of_curve != star.surfaces) {
      return Place::corner;
    }
    const auto u = mesh::difference<3>(complex_.points[v], complex_.points[first]);
    const auto w = mesh::difference<3>(complex_.points[last], complex_.points[v]);
    return mesh::dot<3>(u, w) < sharp_turn * norm(u) * norm(w) ? Place::corner : Place::curve;
  }

  bool contract(int from, int to, Star const& star_from, Star const& star_to, double limit)
  {
    if (!mayMove(to, star_from, star_to) || !staysApart(from, to) || turns(from, to, limit) ||
        (star_from.place == Place::corner && makesNarrow(from, to, limit))) {
      return false;
    }
    for (int i : around_[from]) {
      auto& t = complex_.triangles[i];
      if (std::count(t.begin(), t.end(), to) > 0) {
        is_there_[i] = false;
        for (int v : t) {
          if (v != from) {
            around_[v].erase(std::find(around_[v].begin(), around_[v].end(), i));
          }
        }
      } else {
        std::replace(t.begin(), t.end(), from, to);
        around_[to].push_back(i);
      }
    }
    around_[from].clear();
    return true;
  }

  bool mayMove(int to, Star const& star_from, Star const& star_to) const
  {
    for (int s : star_from.surfaces) {
      if (!model_.isFault(s) && star_to.surfaces.count(s) == 0) {
        return false;
      }
    }
    switch (star_from.place) {
    case Place::patch: return true;
    case Place::curve: return star_from.curves.count(to) > 0;
    case Place::corner: return star_from.curves.count(to) > 0 && star_to.place == Place::corner;
    }
    return false;
  }

  // Where curves lead that begin at a point: their direction and length up to their end, or up to
  // the length `far`.
  struct Direction
  {
    int end;
    Point<3> unit;
    double length; // [m]
  };
  std::vector<Direction> directions(int v, int without, Point<3> const& place, double far) const
  {
    std::vector<Direction> found;
    for (auto const& [next, surfaces] : star(v).curves) {
      if (next == without) {
        continue;
      }
      int before = v, here = next;
      for (auto at = star(here);
           at.place == Place::curve &&
           mesh::distance<3>(complex_.points[here], complex_.points[v]) < far && here != v;
           at = star(here)) {
        const int after =
          at.curves.begin()->first == before ? at.curves.rbegin()->first : at.curves.begin()->first;
        before = here;
        here = after;
      }
      auto direction = mesh::difference<3>(complex_.points[here], place);
      const double length = norm(direction);
      for (double& x : direction) {
        x /= length;
      }
      found.push_back({here, direction, length});
    }
    return found;
  }

  // Whether two curves would enclose an angle below 20 degrees. Curves to one point nearby, the
  // third corner of a small triangle, are merged and do not count.
  bool makesNarrow(int from, int to, double limit) const
  {
    constexpr double far = 10, near = 2; // in units of the limit
    constexpr double smallest = 0.94;    // cosine of 20 degrees
    auto const& place = complex_.points[to];
    const auto moved = directions(from, to, place, far * limit);
    const auto there = directions(to, from, place, far * limit);
    return std::any_of(moved.begin(), moved.end(), [&](auto const& u) {
      return std::any_of(there.begin(), there.end(), [&](auto const& v) {
        return mesh::dot<3>(u.unit, v.unit) > smallest &&
               !(u.end == v.end && u.length < near * limit);
      });
    });
  }

  // Whether each common neighbour of both ends forms a triangle with them, so that no two parts of
  // a surface are joined.
  bool staysApart(int from, int to) const
  {
    const auto a = neighbours(from), b = neighbours(to);
    std::vector<int> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    std::set<int> opposite;
    for (int i : trianglesAt({from, to})) {
      for (int v : complex_.triangles[i]) {
        if (v != from && v != to) {
          opposite.insert(v);
        }
      }
    }
    return std::equal(common.begin(), common.end(), opposite.begin(), opposite.end());
  }

  double height(Triangle const& t) const
  {
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest,
                         mesh::distance<3>(complex_.points[t[k]], complex_.points[t[(k + 1) % 3]]));
    }
    return 2 * areaOf(complex_.points, t) / longest;
  }

  // Whether the normal of a triangle would reverse, or the triangle would become very thin.
  bool turns(int from, int to, double limit) const
  {
    constexpr double largest_turn = 0.17, flat = 0.05, flatter = 0.5;
    std::map<int, Point<3>> normals; // of the surfaces
    for (int i : around_[from]) {
      const auto normal = normalOf(complex_.points, complex_.triangles[i]);
      auto& sum = normals[complex_.surfaces[i]];
      for (int d = 0; d < 3; ++d) {
        sum[d] += normal[d];
      }
    }
    return std::any_of(around_[from].begin(), around_[from].end(), [&](int i) {
      auto moved = complex_.triangles[i];
      if (std::count(moved.begin(), moved.end(), to) > 0) {
        return false;
      }
      std::replace(moved.begin(), moved.end(), from, to);
      const auto normal = normalOf(complex_.points, moved);
      auto const& mean = normals.at(complex_.surfaces[i]);
      return mesh::dot<3>(normal, mean) < largest_turn * norm(normal) * norm(mean) ||
             height(moved) < std::min(flat * limit, flatter * height(complex_.triangles[i]));
    });
  }

  Complex& complex_;
  Model const& model_;
  Shortest const& shortest_;
  std::vector<bool> is_there_;           // (num_triangles)
  std::vector<std::vector<int>> around_; // (num_points) triangles
};
} // namespace

int contractShortEdges(Complex& complex, Model const& model, Shortest const& shortest)
{
  return Contraction(complex, model, shortest).run();
}
} // namespace asperity::geometry
