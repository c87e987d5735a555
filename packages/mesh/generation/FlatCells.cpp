#include "mesh/generation/FlatCells.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/NearestPoint.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/FacetTable.hpp"
#include "mesh/generation/LayerHeights.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <utility>

namespace asperity::mesh
{
namespace
{
constexpr double stretch = 3;       // length over which cells gain what others have lost, over that
constexpr double same_plane = 0.99; // cosine between normals of facets of one plane
constexpr double least_share = 0.2; // of height times its own measure that a cell keeps

// The facets towards which cells become flat.
template <int Dim>
struct Surface
{
  std::vector<typename GlobalMesh<Dim>::Facet> facets;
  std::vector<std::vector<int>> facets_of; // (num_vertices) numbers of facets
  std::vector<double> heights;             // (num_vertices) of cells beside the facets, mean [m]
};

template <int Dim>
Surface<Dim> surfaceOf(GlobalMesh<Dim> const& mesh, std::vector<std::string> const& names,
                       detail::FacetTable<Dim> const& table)
{
  Surface<Dim> surface;
  for (auto const& name : names) {
    auto const& facets = boundaryFacets(mesh, name);
    surface.facets.insert(surface.facets.end(), facets.begin(), facets.end());
  }
  surface.facets_of.resize(mesh.vertices.size());
  surface.heights.assign(mesh.vertices.size(), 0);
  std::vector<int> count(mesh.vertices.size(), 0);
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    auto const& facet = surface.facets[f];
    const double measure = facetMeasure(corners(mesh, facet));
    auto const [first, last] = table.find(facet);
    for (int vertex : facet) {
      surface.facets_of[vertex].push_back(static_cast<int>(f));
      for (auto entry = first; entry != last; ++entry) {
        const double volume = signedMeasure(corners(mesh, mesh.cells[entry->cell]));
        surface.heights[vertex] += Dim * volume / measure;
        ++count[vertex];
      }
    }
  }
  for (std::size_t vertex = 0; vertex < count.size(); ++vertex) {
    surface.heights[vertex] /= std::max(1, count[vertex]);
  }
  return surface;
}

// The point of a surface that is nearest to a vertex.
template <int Dim>
struct Nearest
{
  double distance = std::numeric_limits<double>::infinity(); // [m]
  int facet = -1;
  Point<Dim> place{};
  double layer = 0; // height of the cells there [m]
};

template <int Dim>
Nearest<Dim> nearestOn(GlobalMesh<Dim> const& mesh, Surface<Dim> const& surface, int facet,
                       Point<Dim> const& x)
{
  Simplex simplex{{}, Dim};
  for (int vertex : surface.facets[facet]) {
    simplex.corners.push_back(mesh.vertices[vertex].data());
  }
  auto const point = nearestPoint(simplex, x.data());
  Nearest<Dim> result = {point.distance, facet, {}, 0};
  for (int i = 0; i < Dim; ++i) {
    const int vertex = surface.facets[facet][i];
    result.layer += point.weights[i] * surface.heights[vertex];
    for (int d = 0; d < Dim; ++d) {
      result.place[d] += point.weights[i] * mesh.vertices[vertex][d];
    }
  }
  return result;
}

// A vertex that lies `distance` from a surface with cells of this height moves by this much
// towards it [m].
double lost(double distance, double layer, double height)
{
  const LayerHeights layers(layer, height);
  const double end = layers.end(), most = end - layers.flat(end);
  return distance < end ? distance - layers.flat(distance)
                        : std::max(0., most - (distance - end) / stretch);
}

template <int Dim>
std::vector<std::vector<int>> neighbours(GlobalMesh<Dim> const& mesh)
{
  std::vector<std::vector<int>> result(mesh.vertices.size());
  for (auto const& cell : mesh.cells) {
    for (int a : cell) {
      for (int b : cell) {
        if (a != b) {
          result[a].push_back(b);
        }
      }
    }
  }
  for (auto& list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

// (num_vertices) for those that move. From the surface outwards along edges of cells: a vertex
// tries the facets around the nearest one of its neighbour.
template <int Dim>
std::vector<Nearest<Dim>> nearestPoints(GlobalMesh<Dim> const& mesh, Surface<Dim> const& surface,
                                        double height)
{
  std::vector<Nearest<Dim>> nearest(mesh.vertices.size());
  using Step = std::pair<double, int>; // distance, vertex
  std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
  for (std::size_t vertex = 0; vertex < nearest.size(); ++vertex) {
    if (!surface.facets_of[vertex].empty()) {
      nearest[vertex] = {0, surface.facets_of[vertex].front(), mesh.vertices[vertex],
                         surface.heights[vertex]};
      front.push({0, static_cast<int>(vertex)});
    }
  }
  auto const edges = neighbours(mesh);
  std::set<int> candidates;
  while (!front.empty()) {
    const auto [distance, vertex] = front.top();
    front.pop();
    if (distance > nearest[vertex].distance) {
      continue; // it has found a nearer point since
    }
    candidates.clear();
    for (int corner : surface.facets[nearest[vertex].facet]) {
      auto const& around = surface.facets_of[corner];
      candidates.insert(around.begin(), around.end());
    }
    for (int other : edges[vertex]) {
      if (nearest[other].distance <= distance) {
        continue; // it was here before
      }
      for (int facet : candidates) {
        auto const found = nearestOn<Dim>(mesh, surface, facet, mesh.vertices[other]);
        if (found.distance < nearest[other].distance &&
            lost(found.distance, found.layer, height) > 0) {
          nearest[other] = found;
          front.push({found.distance, other});
        }
      }
    }
  }
  return nearest;
}

// Keeps what is tangential to the planes of the outer boundary in which a vertex lies.
template <int Dim>
void stayOnBoundary(GlobalMesh<Dim> const& mesh, Surface<Dim> const& surface,
                    detail::FacetTable<Dim> const& table, std::vector<Point<Dim>>& moves)
{
  std::set<typename GlobalMesh<Dim>::Facet> own;
  for (auto const& facet : surface.facets) {
    own.insert(detail::sorted(facet));
  }
  std::vector<std::vector<Point<Dim>>> normals(mesh.vertices.size()); // orthonormal
  for (auto const* entry : table.outerEntries()) {
    if (own.count(entry->key) > 0) {
      continue;
    }
    auto const normal = facetNormal(corners(mesh, entry->outward));
    for (int vertex : entry->key) {
      auto rest = normal;
      for (auto const& known : normals[vertex]) {
        const double part = dot<Dim>(rest, known);
        for (int d = 0; d < Dim; ++d) {
          rest[d] -= part * known[d];
        }
      }
      const double size = std::sqrt(dot<Dim>(rest, rest));
      if (size > std::sqrt(1 - same_plane * same_plane)) {
        for (double& part : rest) {
          part /= size;
        }
        normals[vertex].push_back(rest);
      }
    }
  }
  for (std::size_t vertex = 0; vertex < moves.size(); ++vertex) {
    for (auto const& normal : normals[vertex]) {
      const double part = dot<Dim>(moves[vertex], normal);
      for (int d = 0; d < Dim; ++d) {
        moves[vertex][d] -= part * normal[d];
      }
    }
  }
}

// Halves moves where a cell would become too small, until none does.
template <int Dim>
void spareCells(GlobalMesh<Dim> const& mesh, double height, std::vector<Point<Dim>>& moves)
{
  const auto moved = [&](typename GlobalMesh<Dim>::Cell const& cell) {
    auto places = corners(mesh, cell);
    for (int i = 0; i <= Dim; ++i) {
      for (int d = 0; d < Dim; ++d) {
        places[i][d] += moves[cell[i]][d];
      }
    }
    return signedMeasure(places);
  };
  std::set<int> halved;
  do {
    halved.clear();
    for (auto const& cell : mesh.cells) {
      if (moved(cell) < least_share * height * signedMeasure(corners(mesh, cell))) {
        halved.insert(cell.begin(), cell.end());
      }
    }
    for (int vertex : halved) {
      for (double& part : moves[vertex]) {
        part *= 0.5;
      }
    }
  } while (!halved.empty());
}
} // namespace

template <int Dim>
void flattenBeside(GlobalMesh<Dim>& mesh, std::vector<std::string> const& names, double height,
                   std::string const& where)
{
  for (auto const& name : names) {
    ASPERITY_REQUIRE(mesh.boundaries.count(name) > 0,
                     where << ": the mesh has no boundary or fault '" << name << "'. It has "
                           << quotedNames(boundaryNames(mesh)) << '.');
  }
  for (int axis = 0; axis < Dim; ++axis) {
    ASPERITY_REQUIRE(mesh.period[axis] == 0,
                     where << " needs a mesh that is not periodic. Leave it out.");
  }
  const detail::FacetTable<Dim> table(mesh.cells);
  auto const surface = surfaceOf(mesh, names, table);
  auto const nearest = nearestPoints(mesh, surface, height);
  std::vector<Point<Dim>> moves(mesh.vertices.size(), Point<Dim>{});
  for (std::size_t vertex = 0; vertex < moves.size(); ++vertex) {
    auto const& found = nearest[vertex];
    if (found.facet >= 0 && found.distance > 0) {
      const double share = lost(found.distance, found.layer, height) / found.distance;
      for (int d = 0; d < Dim; ++d) {
        moves[vertex][d] = share * (found.place[d] - mesh.vertices[vertex][d]);
      }
    }
  }
  stayOnBoundary<Dim>(mesh, surface, table, moves);
  spareCells<Dim>(mesh, height, moves);
  for (std::size_t vertex = 0; vertex < moves.size(); ++vertex) {
    for (int d = 0; d < Dim; ++d) {
      mesh.vertices[vertex][d] += moves[vertex][d];
    }
  }
}

template void flattenBeside<2>(GlobalMesh<2>&, std::vector<std::string> const&, double,
                               std::string const&);
template void flattenBeside<3>(GlobalMesh<3>&, std::vector<std::string> const&, double,
                               std::string const&);
} // namespace asperity::mesh
