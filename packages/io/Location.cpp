#include "io/Location.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "io/detail/CurveOrder.hpp"
#include "io/parallel/Gather.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity::io
{
namespace
{
// Length, area or volume of a cell or a facet.
template <int Dim, std::size_t N>
double measure(std::array<Point<Dim>, N> const& corners)
{
  if constexpr (N == Dim + 1) {
    return std::abs(mesh::signedMeasure(corners));
  } else {
    return mesh::facetMeasure(corners);
  }
}

// An element belongs to the rank that owns its vertex of least global id.
template <int Dim, class Element>
bool isOwned(Mesh<Dim> const& mesh, Element const& element)
{
  const int least = *std::min_element(element.begin(), element.end(), [&](int left, int right) {
    return mesh.global_ids[left] < mesh.global_ids[right];
  });
  return least < mesh.num_owned;
}

// Fills all but numbers, positions and elements.
template <int Dim, class Element>
Location ownedNodes(std::string const& name, Mesh<Dim> const& mesh,
                    std::vector<Element> const& elements, RCP<const Communicator> const& comm)
{
  std::map<int, double> weight_of_vertex;
  for (auto const& element : elements) {
    const auto corners = mesh::corners(mesh, element);
    const double share = measure<Dim>(corners) / static_cast<double>(element.size());
    for (const int vertex : element) {
      if (vertex < mesh.num_owned) {
        weight_of_vertex[vertex] += share;
      }
    }
  }
  Location location;
  location.name = name;
  location.dimension = Dim;
  location.nodes_per_element = static_cast<int>(Element().size());
  location.comm = comm;
  for (auto const& entry : weight_of_vertex) {
    auto const& point = mesh.vertices[entry.first];
    location.vertices.push_back(entry.first);
    location.vertex_ids.push_back(mesh.global_ids[entry.first]);
    location.weights.push_back(entry.second);
    location.coordinates.insert(location.coordinates.end(), point.begin(), point.end());
  }
  return location;
}

// Of the elements that this rank owns; number_of: from the local vertex to the node's number.
template <int Dim, class Element, class Numbering>
void addElements(Location& location, Mesh<Dim> const& mesh, std::vector<Element> const& elements,
                 Numbering const& number_of)
{
  for (auto const& element : elements) {
    if (!isOwned(mesh, element)) {
      continue;
    }
    const auto corners = mesh::corners(mesh, element);
    bool wraps = false;
    for (std::size_t k = 0; k < element.size(); ++k) {
      wraps = wraps || corners[k] != mesh.vertices[element[k]];
      location.connectivity.push_back(number_of(element[k]));
      location.corners.insert(location.corners.end(), corners[k].begin(), corners[k].end());
    }
    location.wraps.push_back(wraps ? 1 : 0);
  }
  location.is_periodic = mesh.period != Point<Dim>{};
}

// `order`: the global ids of all nodes of the location by number, on every rank.
template <int Dim, class Element>
void number(Location& location, Mesh<Dim> const& mesh, std::vector<Element> const& elements,
            std::vector<GlobalOrdinal> const& order)
{
  std::map<GlobalOrdinal, GlobalOrdinal> number_of_id;
  for (std::size_t i = 0; i < order.size(); ++i) {
    number_of_id[order[i]] = static_cast<GlobalOrdinal>(i);
  }
  location.num_global_nodes = static_cast<GlobalOrdinal>(order.size());
  for (const GlobalOrdinal id : location.vertex_ids) {
    location.node_numbers.push_back(number_of_id.at(id));
  }
  addElements(location, mesh, elements,
              [&](int vertex) { return number_of_id.at(mesh.global_ids[vertex]); });
}

std::vector<GlobalOrdinal> orderById(Location const& location)
{
  std::vector<GlobalOrdinal> ids = detail::gatherToAll(location.vertex_ids, *location.comm);
  std::sort(ids.begin(), ids.end());
  return ids;
}

detail::CurveOrder orderAlong(Location const& location, Mesh<2> const& mesh,
                              std::vector<Mesh<2>::Facet> const& facets)
{
  std::vector<GlobalOrdinal> ends;
  for (auto const& facet : facets) {
    if (isOwned(mesh, facet)) {
      ends.push_back(mesh.global_ids[facet[0]]);
      ends.push_back(mesh.global_ids[facet[1]]);
    }
  }
  const auto all_ends = detail::gatherToAll(ends, *location.comm);
  const auto all_ids = detail::gatherToAll(location.vertex_ids, *location.comm);
  const auto all_coordinates = detail::gatherToAll(location.coordinates, *location.comm);

  std::vector<detail::Segment> segments;
  for (std::size_t i = 0; i < all_ends.size(); i += 2) {
    segments.push_back({all_ends[i], all_ends[i + 1]});
  }
  std::map<GlobalOrdinal, detail::PlanePoint> coordinates;
  for (std::size_t i = 0; i < all_ids.size(); ++i) {
    coordinates[all_ids[i]] = {all_coordinates[2 * i], all_coordinates[2 * i + 1]};
  }
  return detail::orderCurve(segments, coordinates);
}
} // namespace

template <int Dim>
Location boundaryLocation(std::string const& name, Mesh<Dim> const& mesh,
                          std::string const& boundary, RCP<const Communicator> const& comm)
{
  std::vector<std::string> known;
  for (auto const& entry : mesh.boundaries) {
    known.push_back(entry.first);
  }
  const auto found = mesh.boundaries.find(boundary);
  ASPERITY_REQUIRE(found != mesh.boundaries.end(), "The mesh has no boundary '"
                                                     << boundary << "' to be the " << name << "."
                                                     << didYouMean(boundary, known));
  auto const& facets = found->second;
  Location location = ownedNodes(name, mesh, facets, comm);
  const double nodes = detail::sumOverRanks(static_cast<double>(location.numOwned()), *comm);
  ASPERITY_REQUIRE(nodes > 0, "The boundary '" << boundary << "', to be the " << name
                                               << ", has no facets. Check the mesh.");
  if constexpr (Dim == 2) {
    const detail::CurveOrder order = orderAlong(location, mesh, facets);
    number(location, mesh, facets, order.vertex_ids);
    for (const GlobalOrdinal node : location.node_numbers) {
      location.positions.push_back(order.positions[node]);
    }
  } else {
    number(location, mesh, facets, orderById(location));
  }
  return location;
}

template <int Dim>
Location volumeLocation(Mesh<Dim> const& mesh, RCP<const Communicator> const& comm)
{
  Location location = ownedNodes("volume", mesh, mesh.cells, comm);
  location.num_global_nodes = mesh.num_global_vertices;
  location.node_numbers = location.vertex_ids; // every vertex is in a cell: no rank counts them all
  addElements(location, mesh, mesh.cells, [&](int vertex) { return mesh.global_ids[vertex]; });
  return location;
}

template Location boundaryLocation(std::string const&, Mesh<2> const&, std::string const&,
                                   RCP<const Communicator> const&);
template Location boundaryLocation(std::string const&, Mesh<3> const&, std::string const&,
                                   RCP<const Communicator> const&);
template Location volumeLocation(Mesh<2> const&, RCP<const Communicator> const&);
template Location volumeLocation(Mesh<3> const&, RCP<const Communicator> const&);
} // namespace asperity::io
