#include "fem/FaultMesh.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/SplitVertices.hpp"
#include "portability/Renamed.hpp"

#include <Teuchos_OrdinalTraits.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace asperity::fem
{
namespace
{
using Point3 = std::array<double, 3>;
using Shares = std::array<double, 3>; // barycentric coordinates

// The nearest point on the segment from corner i to corner j.
Shares nearestOnEdge(FaultFacet const& facet, int i, int j, Point3 const& place)
{
  auto const edge = mesh::difference<3>(facet.corners[j], facet.corners[i]);
  auto const from = mesh::difference<3>(place, facet.corners[i]);
  const double share = std::clamp(mesh::dot<3>(from, edge) / mesh::dot<3>(edge, edge), 0., 1.);
  Shares result{};
  result[i] = 1 - share;
  result[j] = share;
  return result;
}

Point3 pointAt(FaultFacet const& facet, Shares const& shares)
{
  Point3 point{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      point[k] += shares[i] * facet.corners[i][k];
    }
  }
  return point;
}

// The coordinates of the projection onto the plane of the triangle, negative outside.
Shares projected(FaultFacet const& facet, Point3 const& place)
{
  auto const& c = facet.corners;
  auto const normal = mesh::cross(mesh::difference<3>(c[1], c[0]), mesh::difference<3>(c[2], c[0]));
  Shares result;
  for (int i = 0; i < 3; ++i) {
    auto const a = mesh::difference<3>(c[(i + 1) % 3], place);
    auto const b = mesh::difference<3>(c[(i + 2) % 3], place);
    result[i] = mesh::dot<3>(mesh::cross(a, b), normal) / mesh::dot<3>(normal, normal);
  }
  return result;
}

Shares nearestOn(FaultFacet const& facet, int num_corners, Point3 const& place)
{
  if (num_corners == 2) {
    return nearestOnEdge(facet, 0, 1, place);
  }
  auto const inside = projected(facet, place);
  if (*std::min_element(inside.begin(), inside.end()) >= 0) {
    return inside;
  }
  Shares best{};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    auto const on_edge = nearestOnEdge(facet, i, (i + 1) % 3, place);
    const double distance = mesh::distance<3>(pointAt(facet, on_edge), place);
    if (distance < least) {
      least = distance;
      best = on_edge;
    }
  }
  return best;
}

double longestEdge(FaultFacet const& facet, int num_corners)
{
  double longest = 0;
  for (int i = 0; i < num_corners; ++i) {
    for (int j = 0; j < i; ++j) {
      longest = std::max(longest, mesh::distance<3>(facet.corners[i], facet.corners[j]));
    }
  }
  return longest;
}

// The integral of grad(phi_i) . grad(phi_j) over a facet: of a triangle e_i . e_j / (4 A) with the
// edges e opposite to the corners, in one sense around it.
double gradientProduct(FaultFacet const& facet, int num_corners, int i, int j)
{
  if (num_corners == 2) {
    return (i == j ? 1 : -1) / facet.measure;
  }
  auto const& c = facet.corners;
  auto const a = mesh::difference<3>(c[(i + 2) % 3], c[(i + 1) % 3]);
  auto const b = mesh::difference<3>(c[(j + 2) % 3], c[(j + 1) % 3]);
  return mesh::dot<3>(a, b) / (4 * facet.measure);
}

// The gradient of the basis function of corner i: of a triangle n x e_i / (2 A), with the unit
// normal n and the edge e_i opposite to the corner.
Point3 basisGradient(FaultFacet const& facet, int num_corners, int i)
{
  auto const& c = facet.corners;
  auto const scaled = [](Point3 const& a, double factor) {
    return Point3{factor * a[0], factor * a[1], factor * a[2]};
  };
  if (num_corners == 2) {
    return scaled(mesh::difference<3>(c[i], c[1 - i]), 1 / (facet.measure * facet.measure));
  }
  auto const normal = mesh::cross(mesh::difference<3>(c[1], c[0]), mesh::difference<3>(c[2], c[0]));
  auto const edge = mesh::difference<3>(c[(i + 2) % 3], c[(i + 1) % 3]);
  return scaled(mesh::cross(normal, edge), 1 / (4 * facet.measure * facet.measure));
}

RCP<const Map> mapOf(std::vector<GlobalOrdinal> const& ids,
                     RCP<const Communicator> const& communicator)
{
  auto const unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return rcp(new Map(unknown, Teuchos::arrayViewFromVector(ids), 0, communicator));
}

// Numbers ids in the order in which they come; those before endOwned() are owned.
class NumberedIds
{
public:
  int of(GlobalOrdinal id)
  {
    auto const [place, is_new] = numbers_.emplace(id, static_cast<int>(ids_.size()));
    if (is_new) {
      ids_.push_back(id);
    }
    return place->second;
  }

  void endOwned() { num_owned_ = ids_.size(); }

  FaultMesh::Numbering maps(RCP<const Communicator> const& communicator) const
  {
    const auto first = ids_.begin(), end = first + static_cast<std::ptrdiff_t>(num_owned_);
    return {mapOf({first, end}, communicator), mapOf(ids_, communicator)};
  }

private:
  std::map<GlobalOrdinal, int> numbers_;
  std::vector<GlobalOrdinal> ids_;
  std::size_t num_owned_ = 0;
};

std::vector<int> ofOwned(std::vector<int> const& of_columns, Map const& owned)
{
  return {of_columns.begin(),
          of_columns.begin() + static_cast<std::ptrdiff_t>(numLocalElements(owned))};
}
} // namespace

FaultMesh::FaultMesh(int num_corners, std::vector<FaultFacet> facets, Numbering nodes,
                     Numbering points, std::vector<int> point_of_column)
    : num_corners_(num_corners)
    , facets_(std::move(facets))
    , nodes_(std::move(nodes))
    , numbering_of_points_(std::move(points))
    , point_of_column_(std::move(point_of_column))
    , points_(ofOwned(point_of_column_, *nodes_.owned),
              static_cast<int>(numLocalElements(*numbering_of_points_.owned)),
              *nodes_.owned->getComm())
{
}

std::vector<double> FaultMesh::withGhosts(std::vector<double> const& values) const
{
  Vector mine(nodes_.owned), all(nodes_.columns);
  auto const host = mine.getLocalViewHost(Tpetra::Access::OverwriteAll);
  ASPERITY_ASSERT(values.size() == host.extent(0));
  for (std::size_t i = 0; i < values.size(); ++i) {
    host(i, 0) = values[i];
  }
  all.doImport(mine, Import(nodes_.owned, nodes_.columns), Tpetra::INSERT);
  auto const result = all.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> copy(result.extent(0));
  for (std::size_t i = 0; i < copy.size(); ++i) {
    copy[i] = result(i, 0);
  }
  return copy;
}

RCP<const CrsMatrix> FaultMesh::stiffness(std::vector<double> const& c) const
{
  auto const values = withGhosts(c);
  const int num_rows = points_.numPoints();
  std::vector<std::map<int, double>> rows(num_rows);
  for (auto const& facet : facets_) {
    double mean = 0;
    for (int i = 0; i < num_corners_; ++i) {
      mean += values[facet.nodes[i]] / num_corners_;
    }
    for (int i = 0; i < num_corners_; ++i) {
      const int row = point_of_column_[facet.nodes[i]];
      for (int j = 0; row < num_rows && j < num_corners_; ++j) {
        rows[row][point_of_column_[facet.nodes[j]]] +=
          mean * gradientProduct(facet, num_corners_, i, j);
      }
    }
  }
  std::size_t most = 1;
  for (auto const& row : rows) {
    most = std::max(most, row.size());
  }
  auto const& [owned, of_columns] = numbering_of_points_;
  auto const K = rcp(new CrsMatrix(owned, of_columns, most));
  for (int i = 0; i < num_rows; ++i) {
    std::vector<LocalOrdinal> columns;
    std::vector<double> entries;
    for (auto const& [column, entry] : rows[i]) {
      columns.push_back(column);
      entries.push_back(entry);
    }
    K->insertLocalValues(i, Teuchos::arrayViewFromVector(columns),
                         Teuchos::arrayViewFromVector(entries));
  }
  K->fillComplete(owned, owned);
  return K;
}

std::vector<double> FaultMesh::gradient(std::vector<double> const& p) const
{
  auto const values = withGhosts(p);
  std::vector<double> result(3 * p.size(), 0.), measures(p.size(), 0.);
  const auto num_nodes = static_cast<int>(p.size());
  for (auto const& facet : facets_) {
    Point3 gradient{};
    for (int i = 0; i < num_corners_; ++i) {
      auto const of_basis = basisGradient(facet, num_corners_, i);
      for (int k = 0; k < 3; ++k) {
        gradient[k] += values[facet.nodes[i]] * of_basis[k];
      }
    }
    for (int i = 0; i < num_corners_; ++i) {
      const int node = facet.nodes[i];
      for (int k = 0; node < num_nodes && k < 3; ++k) {
        result[3 * node + k] += facet.measure * gradient[k];
      }
      if (node < num_nodes) {
        measures[node] += facet.measure;
      }
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] /= measures[i / 3];
  }
  return result;
}

// Which facet of this rank is the one that all ranks choose at the least distance, if it has that:
// the one with the smallest global numbers. Several ranks may have it.
std::optional<std::size_t> FaultMesh::chosen(std::vector<double> const& distances,
                                             double least) const
{
  using Key = std::array<GlobalOrdinal, 3>;
  std::map<Key, std::size_t> candidates;
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    if (distances[i] <= least) {
      Key key{};
      for (int k = 0; k < num_corners_; ++k) {
        key[k] = nodes_.columns->getGlobalElement(facets_[i].nodes[k]);
      }
      candidates.emplace(key, i);
    }
  }
  for (int k = 0; k < num_corners_; ++k) {
    const auto mine =
      candidates.empty() ? std::numeric_limits<GlobalOrdinal>::max() : candidates.begin()->first[k];
    const auto smallest = minOverRanks(mine, *nodes_.owned->getComm());
    if (mine != smallest) {
      candidates.clear();
    }
  }
  return candidates.empty() ? std::nullopt : std::optional(candidates.begin()->second);
}

FaultMesh::Nearest FaultMesh::nearest(std::array<double, 3> const& place) const
{
  std::vector<double> distances;
  double least = std::numeric_limits<double>::infinity();
  for (auto const& facet : facets_) {
    auto const point = pointAt(facet, nearestOn(facet, num_corners_, place));
    distances.push_back(mesh::distance<3>(point, place));
    least = std::min(least, distances.back());
  }
  auto const& communicator = *nodes_.owned->getComm();
  Nearest result{minOverRanks(least, communicator), 0, {}};
  if (auto const best = chosen(distances, result.distance)) {
    auto const& facet = facets_[*best];
    auto const shares = nearestOn(facet, num_corners_, place);
    result.cell_size = longestEdge(facet, num_corners_);
    for (int i = 0; i < num_corners_; ++i) {
      if (facet.nodes[i] < static_cast<int>(numLocalElements(*nodes_.owned))) {
        result.shares.emplace_back(facet.nodes[i], shares[i]);
      }
    }
  }
  result.cell_size = maxOverRanks(result.cell_size, communicator);
  return result;
}

template <int Dim>
std::shared_ptr<const FaultMesh> makeFaultMesh(Mesh<Dim> const& mesh, FaultSurface const& surface)
{
  const mesh::FaultPairs pairs(mesh.splits);
  NumberedIds nodes, points;
  std::vector<int> point_of_column;
  const auto number = [&](int vertex) {
    const int node = nodes.of(mesh.global_ids[vertex]);
    if (node == static_cast<int>(point_of_column.size())) { // a new one
      point_of_column.push_back(points.of(mesh.global_ids[pairs.placeOf(vertex)]));
    }
    return node;
  };
  for (int vertex : surface.vertices()) {
    number(vertex);
  }
  nodes.endOwned();
  points.endOwned();
  std::vector<FaultFacet> facets;
  for (auto const& vertices : mesh.boundaries.at(surface.name())) {
    const bool is_mine = std::any_of(vertices.begin(), vertices.end(),
                                     [&](int vertex) { return surface.nodeAt(vertex) >= 0; });
    if (!is_mine) {
      continue;
    }
    FaultFacet facet;
    auto const corners = mesh::corners(mesh, vertices);
    facet.measure = mesh::facetMeasure(corners);
    for (int i = 0; i < Dim; ++i) {
      std::copy(corners[i].begin(), corners[i].end(), facet.corners[i].begin());
      facet.nodes[i] = number(vertices[i]);
    }
    facets.push_back(facet);
  }
  auto of_nodes = nodes.maps(surface.communicator());
  auto of_points = points.maps(surface.communicator());
  return std::make_shared<FaultMesh>(Dim, std::move(facets), std::move(of_nodes),
                                     std::move(of_points), std::move(point_of_column));
}

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template std::shared_ptr<const FaultMesh> makeFaultMesh(Mesh<DIM> const&, FaultSurface const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::fem
