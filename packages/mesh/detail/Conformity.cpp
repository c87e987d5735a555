#include "mesh/detail/Conformity.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <cmath>
#include <vector>

namespace asperity::mesh::detail
{
namespace
{
// Facets overlap if the angle between them is smaller than this [rad]. It exceeds the rounding of
// coordinates in single precision (6e-8 of the body's size) in a body a thousand cells long.
constexpr double smallest_angle = 1e-4;

template <int Dim>
double length(Point<Dim> const& vector)
{
  return std::sqrt(dot<Dim>(vector, vector));
}

// A facet by the vectors from one of its corners to the others.
template <int Dim>
using Arms = std::array<Point<Dim>, Dim - 1>;

template <int Dim>
Arms<Dim> armsFrom(std::array<Point<Dim>, Dim> const& corners, int from)
{
  Arms<Dim> arms;
  for (int i = 0; i < Dim - 1; ++i) {
    arms[i] = difference<Dim>(corners[(from + 1 + i) % Dim], corners[from]);
  }
  return arms;
}

bool haveSameDirection(Point<2> const& a, Point<2> const& b)
{
  const double sine = (a[0] * b[1] - a[1] * b[0]) / (length<2>(a) * length<2>(b));
  return dot<2>(a, b) > 0.0 && std::abs(sine) < smallest_angle;
}

bool overlap(Arms<2> const& a, Arms<2> const& b) { return haveSameDirection(a[0], b[0]); }

// The angle of a direction in the plane of two axes, of which the first has length 1.
double angleIn(Point<3> const& first, Point<3> const& second, Point<3> const& direction)
{
  return std::atan2(dot<3>(direction, second), dot<3>(direction, first));
}

// Whether two sectors lie in one plane and overlap.
bool overlap(Arms<3> const& a, Arms<3> const& b)
{
  auto const normal = cross(a[0], a[1]);
  for (auto const& arm : b) {
    if (std::abs(dot<3>(arm, normal)) > smallest_angle * length<3>(arm) * length<3>(normal)) {
      return false;
    }
  }
  auto first = a[0];
  auto second = cross(normal, a[0]);
  const double size_first = length<3>(first), size_second = length<3>(second);
  for (int d = 0; d < 3; ++d) {
    first[d] /= size_first;
    second[d] /= size_second;
  }
  const double end = angleIn(first, second, a[1]); // of the sector that begins at 0
  double begin_b = angleIn(first, second, b[0]);
  double width_b = std::remainder(angleIn(first, second, b[1]) - begin_b, 2.0 * M_PI);
  if (width_b < 0.0) {
    begin_b += width_b;
    width_b = -width_b;
  }
  for (const double turn : {-2.0 * M_PI, 0.0, 2.0 * M_PI}) {
    const double begin = begin_b + turn;
    if (std::min(end, begin + width_b) - std::max(0.0, begin) > smallest_angle) {
      return true;
    }
  }
  return false;
}

template <int Dim>
bool coincide(Point<Dim> const& a, Point<Dim> const& b)
{
  return length<Dim>(difference<Dim>(a, b)) <
         smallest_angle * std::min(length<Dim>(a), length<Dim>(b));
}

template <int Dim>
bool isAmong(Arms<Dim> const& arms, Point<Dim> const& place)
{
  return std::any_of(arms.begin(), arms.end(),
                     [&](auto const& arm) { return coincide<Dim>(arm, place); });
}

template <int Dim>
bool haveSameCorners(Arms<Dim> const& a, Arms<Dim> const& b)
{
  return std::all_of(b.begin(), b.end(), [&](auto const& place) { return isAmong<Dim>(a, place); });
}

bool contains(Arms<2> const& edge, Point<2> const& place)
{
  return haveSameDirection(edge[0], place) && length<2>(place) < length<2>(edge[0]);
}

// Whether s, t >= 0 and s + t <= 1 in place = s a0 + t a1, for a point in the plane of the face.
bool contains(Arms<3> const& face, Point<3> const& place)
{
  auto const& [a, b] = face;
  const double aa = dot<3>(a, a), ab = dot<3>(a, b), bb = dot<3>(b, b);
  const double pa = dot<3>(place, a), pb = dot<3>(place, b);
  const double determinant = aa * bb - ab * ab;
  const double s = (pa * bb - pb * ab) / determinant, t = (pb * aa - pa * ab) / determinant;
  return s > -smallest_angle && t > -smallest_angle && s + t < 1.0 + smallest_angle;
}

template <int Dim>
struct AtCorner
{
  int vertex;
  int corner;
  typename FacetTable<Dim>::Entry const* entry;
};

// The facets that belong to one cell only, once for each of their vertices of which this rank has
// all cells, sorted by vertex.
template <int Dim>
std::vector<AtCorner<Dim>> facetsOfOneCell(FacetTable<Dim> const& table, int num_complete)
{
  std::vector<AtCorner<Dim>> found;
  for (auto const* entry : table.outerEntries()) {
    for (int corner = 0; corner < Dim; ++corner) {
      const int vertex = entry->outward[corner];
      if (vertex < num_complete) {
        found.push_back({vertex, corner, entry});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](auto const& a, auto const& b) { return a.vertex < b.vertex; });
  return found;
}

template <template <int> class AnyMesh, int Dim>
std::string cornersText(AnyMesh<Dim> const& mesh, AtCorner<Dim> const& facet)
{
  return mesh::text(corners(mesh, facet.entry->outward));
}

// "vertex 4 at (0.5, 0.5) m lies inside ..." if a corner of the second facet lies in the first.
template <template <int> class AnyMesh, int Dim>
std::string hangingVertexText(AnyMesh<Dim> const& mesh, AtCorner<Dim> const& facet,
                              AtCorner<Dim> const& other)
{
  auto const points = corners(mesh, other.entry->outward);
  auto const arms = armsFrom<Dim>(corners(mesh, facet.entry->outward), facet.corner);
  auto const places = armsFrom<Dim>(points, other.corner);
  for (int i = 0; i < Dim - 1; ++i) {
    if (contains(arms, places[i]) && !isAmong<Dim>(arms, places[i])) {
      const int corner = (other.corner + 1 + i) % Dim;
      return "vertex " + std::to_string(globalId(mesh, other.entry->outward[corner])) + " at " +
             mesh::text(points[corner]) + " m lies inside the " + (Dim == 2 ? "edge" : "face") +
             " with the corners " + cornersText(mesh, facet) + ", which no second cell shares";
    }
  }
  return "";
}

template <template <int> class AnyMesh, int Dim>
[[noreturn]] void refuse(AnyMesh<Dim> const& mesh, AtCorner<Dim> const& a, AtCorner<Dim> const& b,
                         std::string const& where)
{
  auto what = hangingVertexText(mesh, a, b);
  if (what.empty()) {
    what = hangingVertexText(mesh, b, a);
  }
  if (what.empty()) {
    what = "the face with the corners " + cornersText(mesh, a) + " and the one with the corners " +
           cornersText(mesh, b) + " lie on each other and are not the same";
  }
  throw InputError(where + ": " + what +
                   ". The mesh does not conform: the body would open there like a crack. Let cells "
                   "share whole " +
                   (Dim == 2 ? "edges" : "faces") +
                   "; in Gmsh, regions that touch need common curves and surfaces "
                   "(BooleanFragments, Coherence).");
}
} // namespace

template <template <int> class AnyMesh, int Dim>
void requireConforming(AnyMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                       std::string const& where)
{
  auto const facets = facetsOfOneCell<Dim>(table, numComplete(mesh));
  for (auto a = facets.begin(); a != facets.end(); ++a) {
    auto const arms = armsFrom<Dim>(corners(mesh, a->entry->outward), a->corner);
    for (auto b = a + 1; b != facets.end() && b->vertex == a->vertex; ++b) {
      auto const others = armsFrom<Dim>(corners(mesh, b->entry->outward), b->corner);
      if (overlap(arms, others) && !haveSameCorners<Dim>(arms, others)) {
        refuse(mesh, *a, *b, where);
      }
    }
  }
}

template void requireConforming(GlobalMesh<2> const&, FacetTable<2> const&, std::string const&);
template void requireConforming(GlobalMesh<3> const&, FacetTable<3> const&, std::string const&);
template void requireConforming(Mesh<2> const&, FacetTable<2> const&, std::string const&);
template void requireConforming(Mesh<3> const&, FacetTable<3> const&, std::string const&);
} // namespace asperity::mesh::detail
