#include "arrangement/exact/ExactArrangement.hpp"

#include "base/Errors.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <CGAL/version.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#if CGAL_VERSION_NR >= 1060000000
#include <variant>
#else
#include <boost/variant/get.hpp>
#endif

namespace asperity::geometry
{
namespace
{
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact = Kernel::FT;
using Point3 = Kernel::Point_3;
using Point2 = Kernel::Point_2;
using Segment3 = Kernel::Segment_3;
using Triangle3 = Kernel::Triangle_3;
using Triangulation =
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::Exact_intersections_tag>;

// What an intersection consists of: a Value, or null. CGAL 6 has types of the standard library
// where CGAL 5 has those of Boost.
template <class Value, class Intersection>
Value const* part(Intersection const& intersection)
{
#if CGAL_VERSION_NR >= 1060000000
  return std::get_if<Value>(&*intersection);
#else
  return boost::get<Value>(&*intersection);
#endif
}

double rounded(Exact const& number) { return CGAL::to_double(number); }

Point<3> rounded(Point3 const& point)
{
  return {rounded(point.x()), rounded(point.y()), rounded(point.z())};
}

// A triangle of the input, and the points and segments in which others intersect it.
struct Piece
{
  int surface;
  Triangle vertices; // in the list of exact points
  std::vector<Segment3> segments;
  std::vector<Point3> points;
};

class PointList
{
public:
  int numberOf(Point3 const& point)
  {
    const auto [place, is_new] = numbers_.emplace(point, static_cast<int>(points_.size()));
    if (is_new) {
      points_.push_back(point);
    }
    return place->second;
  }
  std::vector<Point3> const& points() const { return points_; }

private:
  std::map<Point3, int> numbers_;
  std::vector<Point3> points_;
};

class Arranging
{
public:
  explicit Arranging(std::vector<NamedSurface> const& surfaces) : surfaces_(surfaces)
  {
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      auto const& surface = surfaces[s].surface;
      const auto offset = static_cast<int>(given_.size());
      offsets_.push_back(offset);
      for (auto const& p : surface.points) {
        given_.emplace_back(p[0], p[1], p[2]);
      }
      for (auto const& t : surface.triangles) {
        pieces_.push_back(
          {static_cast<int>(s), {t[0] + offset, t[1] + offset, t[2] + offset}, {}, {}});
      }
    }
  }

  Arrangement run()
  {
    intersectPairs();
    findPointsOnEdges();
    for (auto const& piece : pieces_) {
      divide(piece);
    }
    return result();
  }

private:
  Point3 const& corner(Piece const& piece, int k) const { return given_[piece.vertices[k]]; }
  Triangle3 triangle(Piece const& piece) const
  {
    return Triangle3(corner(piece, 0), corner(piece, 1), corner(piece, 2));
  }
  std::string const& nameOf(Piece const& piece) const { return surfaces_[piece.surface].name; }

  void intersectPairs()
  {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      boxes.emplace_back(triangle(pieces_[i]).bbox(), static_cast<int>(i));
    }
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](Box const& a, Box const& b) {
      auto& first = pieces_[a.info()];
      auto& second = pieces_[b.info()];
      first.surface == second.surface ? requireApart(first, second) : intersect(first, second);
    });
  }

  void intersect(Piece& first, Piece& second)
  {
    const auto a = triangle(first), b = triangle(second);
    if (!CGAL::do_intersect(a, b)) {
      return;
    }
    const auto common = CGAL::intersection(a, b);
    if (!common) {
      return;
    }
    if (auto const* segment = part<Segment3>(common)) {
      first.segments.push_back(*segment);
      second.segments.push_back(*segment);
    } else if (auto const* point = part<Point3>(common)) {
      first.points.push_back(*point);
      second.points.push_back(*point);
    } else {
      auto const* inner = part<Triangle3>(common);
      const auto place = inner != nullptr ? rounded(inner->vertex(0))
                                          : rounded(part<std::vector<Point3>>(common)->front());
      throw InputError("'" + nameOf(first) + "' and '" + nameOf(second) +
                       "' lie in one plane and overlap at " + placeText(place) +
                       ". Surfaces may meet along lines: cut the one where it reaches the other, "
                       "or give the common part to one of them.");
    }
  }

  // Triangles of one surface may have a corner or an edge in common, nothing else.
  void requireApart(Piece const& first, Piece const& second) const
  {
    std::vector<int> shared, rest_first, rest_second;
    for (int v : first.vertices) {
      const bool is_shared = std::count(second.vertices.begin(), second.vertices.end(), v) > 0;
      (is_shared ? shared : rest_first).push_back(v);
    }
    std::copy_if(second.vertices.begin(), second.vertices.end(), std::back_inserter(rest_second),
                 [&](int v) { return std::count(shared.begin(), shared.end(), v) == 0; });
    bool do_touch = false;
    if (shared.empty()) {
      do_touch = CGAL::do_intersect(triangle(first), triangle(second));
    } else if (shared.size() == 1) {
      do_touch = CGAL::do_intersect(triangle(first),
                                    Segment3(given_[rest_second[0]], given_[rest_second[1]])) ||
                 CGAL::do_intersect(triangle(second),
                                    Segment3(given_[rest_first[0]], given_[rest_first[1]]));
    } else {
      auto const& a = given_[shared[0]];
      auto const& b = given_[shared[1]];
      auto const& c = given_[rest_first[0]];
      auto const& d = given_[rest_second[0]];
      do_touch =
        CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
    }
    ASPERITY_REQUIRE(!do_touch, "'" << nameOf(first) << "' crosses, touches or overlaps itself at "
                                    << placeText(rounded(corner(first, 0)))
                                    << ". Cut it into surfaces with a name each.");
  }

  // A point on an edge divides all triangles at the edge.
  void findPointsOnEdges()
  {
    for (auto const& piece : pieces_) {
      const auto put = [&](Point3 const& point) {
        for (int k = 0; k < 3; ++k) {
          auto const& a = corner(piece, k);
          auto const& b = corner(piece, (k + 1) % 3);
          if (point != a && point != b && CGAL::collinear(a, b, point)) {
            on_edges_[edgeOf(piece.vertices, k)].insert(point);
          }
        }
      };
      for (auto const& segment : piece.segments) {
        put(segment.source());
        put(segment.target());
      }
      for (auto const& point : piece.points) {
        put(point);
      }
    }
  }

  std::set<Point3> const& pointsOn(Edge const& edge) const
  {
    static const std::set<Point3> none;
    const auto found = on_edges_.find(edge);
    return found == on_edges_.end() ? none : found->second;
  }

  void divide(Piece const& piece)
  {
    bool is_whole = piece.segments.empty() && piece.points.empty();
    for (int k = 0; k < 3; ++k) {
      is_whole = is_whole && pointsOn(edgeOf(piece.vertices, k)).empty();
    }
    if (is_whole) {
      add(piece.surface, {all_.numberOf(corner(piece, 0)), all_.numberOf(corner(piece, 1)),
                          all_.numberOf(corner(piece, 2))});
    } else {
      triangulate(piece);
    }
  }

  // Projects along the axis along which the projection of the triangle is largest.
  void triangulate(Piece const& piece)
  {
    const auto whole = triangle(piece);
    const auto plane = whole.supporting_plane();
    const std::array<Exact, 3> normal = {plane.a(), plane.b(), plane.c()};
    int up = 0;
    for (int d = 1; d < 3; ++d) {
      up = std::abs(rounded(normal[d])) > std::abs(rounded(normal[up])) ? d : up;
    }
    const int i = (up + 1) % 3, j = (up + 2) % 3;
    const auto flat = [&](Point3 const& p) { return Point2(p[i], p[j]); };
    Triangulation triangulation;
    std::map<Point2, Point3> lifted;
    const auto insert = [&](Point3 const& point) {
      lifted.emplace(flat(point), point);
      return triangulation.insert(flat(point));
    };
    std::array<Triangulation::Vertex_handle, 3> corners;
    for (int k = 0; k < 3; ++k) {
      corners[k] = insert(corner(piece, k));
    }
    for (int k = 0; k < 3; ++k) {
      triangulation.insert_constraint(corners[k], corners[(k + 1) % 3]);
      for (auto const& point : pointsOn(edgeOf(piece.vertices, k))) {
        insert(point);
      }
    }
    for (auto const& point : piece.points) {
      insert(point);
    }
    for (auto const& segment : piece.segments) {
      const auto from = insert(segment.source()), to = insert(segment.target());
      if (from != to) {
        triangulation.insert_constraint(from, to);
      }
    }
    const auto numberAt = [&](Point2 const& place) {
      auto found = lifted.find(place);
      if (found == lifted.end()) { // where segments cross
        std::array<Exact, 3> x;
        x[i] = place.x();
        x[j] = place.y();
        x[up] = -(plane.d() + normal[i] * x[i] + normal[j] * x[j]) / normal[up];
        found = lifted.emplace(place, Point3(x[0], x[1], x[2])).first;
      }
      return all_.numberOf(found->second);
    };
    const bool is_upright =
      CGAL::orientation(flat(whole[0]), flat(whole[1]), flat(whole[2])) == CGAL::COUNTERCLOCKWISE;
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end();
         ++face) {
      Triangle vertices;
      for (int k = 0; k < 3; ++k) {
        vertices[k] = numberAt(face->vertex(k)->point());
      }
      if (!is_upright) {
        std::swap(vertices[1], vertices[2]);
      }
      add(piece.surface, vertices);
    }
  }

  void add(int surface, Triangle const& vertices)
  {
    complex_.triangles.push_back(vertices);
    complex_.surfaces.push_back(surface);
  }

  Arrangement result()
  {
    Arrangement arrangement;
    arrangement.complex = std::move(complex_);
    // Numbers that are known by intervals become exact before they are rounded if these are wide.
    const double precision = Exact::get_relative_precision_of_to_double();
    Exact::set_relative_precision_of_to_double(1e-14);
    for (auto const& point : all_.points()) {
      arrangement.complex.points.push_back(rounded(point));
    }
    Exact::set_relative_precision_of_to_double(precision);
    const auto known = static_cast<int>(all_.points().size());
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      auto& numbers = arrangement.points_of.emplace_back();
      for (std::size_t p = 0; p < surfaces_[s].surface.points.size(); ++p) {
        const int number = all_.numberOf(given_[offsets_[s] + p]);
        numbers.push_back(number < known ? number : -1);
      }
    }
    return arrangement;
  }

  std::vector<NamedSurface> const& surfaces_;
  std::vector<Point3> given_; // of all surfaces, one after the other
  std::vector<std::size_t> offsets_;
  std::vector<Piece> pieces_;
  std::map<Edge, std::set<Point3>> on_edges_;
  PointList all_;
  Complex complex_;
};
} // namespace

Arrangement arrange(std::vector<NamedSurface> const& surfaces) { return Arranging(surfaces).run(); }
} // namespace asperity::geometry
