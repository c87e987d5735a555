#include "mesh/MeshQuality.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/FacetTable.hpp"

#include <limits>

namespace asperity::mesh
{
namespace
{
// The angles between facets (edges in 2D): pi minus the angle between their outward normals.
template <int Dim>
double smallestAngle(GlobalMesh<Dim> const& mesh, typename GlobalMesh<Dim>::Cell const& cell)
{
  std::array<Point<Dim>, Dim + 1> normals;
  for (int corner = 0; corner <= Dim; ++corner) {
    const auto facet = detail::oppositeFacet(cell, corner);
    normals[corner] = facetNormal(corners(mesh, facet));
  }
  double smallest = std::acos(-1.0);
  for (int i = 0; i <= Dim; ++i) {
    for (int j = 0; j < i; ++j) {
      const double cosine = std::clamp(-dot<Dim>(normals[i], normals[j]), -1.0, 1.0);
      smallest = std::min(smallest, std::acos(cosine));
    }
  }
  return smallest;
}
template <int Dim>
Point<Dim> meanOf(std::vector<Point<Dim>> const& points)
{
  Point<Dim> mean{};
  for (auto const& point : points) {
    for (int d = 0; d < Dim; ++d) {
      mean[d] += point[d] / static_cast<double>(points.size());
    }
  }
  return mean;
}
} // namespace

template <template <int> class AnyMesh, int Dim>
std::vector<double> cellDiameters(AnyMesh<Dim> const& mesh)
{
  std::vector<double> result;
  result.reserve(mesh.cells.size());
  for (auto const& cell : mesh.cells) {
    result.push_back(longestEdge(corners(mesh, cell)));
  }
  return result;
}

template <int Dim>
CellSizes<Dim> cellSizes(GlobalMesh<Dim> const& mesh)
{
  const auto all = cellDiameters(mesh);
  CellSizes<Dim> sizes;
  if (all.empty()) {
    return sizes;
  }
  sizes.smallest_diameter = *std::min_element(all.begin(), all.end());
  sizes.largest_diameter = *std::max_element(all.begin(), all.end());
  sizes.smallest_angle = std::acos(-1.0);
  sizes.shortest_edge = std::numeric_limits<double>::infinity();
  for (auto const& cell : mesh.cells) {
    const auto points = corners(mesh, cell);
    sizes.measure += signedMeasure(points);
    if (const double angle = smallestAngle(mesh, cell); angle < sizes.smallest_angle) {
      sizes.smallest_angle = angle;
      sizes.place_of_smallest_angle = meanOf<Dim>({points.begin(), points.end()});
    }
    for (int i = 0; i <= Dim; ++i) {
      for (int j = 0; j < i; ++j) {
        if (const double edge = distance<Dim>(points[i], points[j]); edge < sizes.shortest_edge) {
          sizes.shortest_edge = edge;
          sizes.place_of_shortest_edge = meanOf<Dim>({points[i], points[j]});
        }
      }
    }
  }
  return sizes;
}

template <template <int> class AnyMesh, int Dim>
std::vector<typename Mesh<Dim>::Facet> const& boundaryFacets(AnyMesh<Dim> const& mesh,
                                                             std::string const& name)
{
  const auto found = mesh.boundaries.find(name);
  ASPERITY_REQUIRE(found != mesh.boundaries.end(),
                   "The mesh has no boundary '"
                     << name << "'."
                     << (mesh.boundaries.empty() ? " It has none."
                                                 : didYouMean(name, boundaryNames(mesh))));
  return found->second;
}

template <template <int> class AnyMesh, int Dim>
std::vector<int> boundaryVertices(AnyMesh<Dim> const& mesh, std::string const& name)
{
  std::vector<int> vertices;
  for (auto const& facet : boundaryFacets(mesh, name)) {
    vertices.insert(vertices.end(), facet.begin(), facet.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

template <int Dim>
double shortestEdge(GlobalMesh<Dim> const& mesh, std::string const& boundary)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (auto const& facet : boundaryFacets(mesh, boundary)) {
    const auto points = corners(mesh, facet);
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < i; ++j) {
        shortest = std::min(shortest, distance<Dim>(points[i], points[j]));
      }
    }
  }
  return shortest;
}

#define ASPERITY_INSTANTIATE(AnyMesh, Dim)                                                         \
  template std::vector<double> cellDiameters(AnyMesh<Dim> const&);                                 \
  template std::vector<Mesh<Dim>::Facet> const& boundaryFacets(AnyMesh<Dim> const&,                \
                                                               std::string const&);                \
  template std::vector<int> boundaryVertices(AnyMesh<Dim> const&, std::string const&);
ASPERITY_INSTANTIATE(GlobalMesh, 2)
ASPERITY_INSTANTIATE(GlobalMesh, 3)
ASPERITY_INSTANTIATE(Mesh, 2)
ASPERITY_INSTANTIATE(Mesh, 3)
#undef ASPERITY_INSTANTIATE

template CellSizes<2> cellSizes(GlobalMesh<2> const&);
template CellSizes<3> cellSizes(GlobalMesh<3> const&);
template double shortestEdge(GlobalMesh<2> const&, std::string const&);
template double shortestEdge(GlobalMesh<3> const&, std::string const&);
} // namespace asperity::mesh
