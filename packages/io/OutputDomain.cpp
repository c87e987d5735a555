#include "io/OutputDomain.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "base/parallel/Directory.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"
#include "io/detail/CurveOrder.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
OutputDomain ownedNodes(std::string const& name, Mesh<Dim> const& mesh,
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
  if constexpr (std::tuple_size_v<Element> == Dim + 1) {
    for (auto const& split : mesh.splits) { // no cell has the tip of a fault
      if (split.is_tip && split.plus < mesh.num_owned) {
        weight_of_vertex.emplace(split.plus, 0.);
      }
    }
  }
  OutputDomain domain;
  domain.name = name;
  domain.dimension = Dim;
  domain.nodes_per_element = static_cast<int>(Element().size());
  domain.comm = comm;
  for (auto const& entry : weight_of_vertex) {
    auto const& point = mesh.vertices[entry.first];
    domain.vertices.push_back(entry.first);
    domain.vertex_ids.push_back(mesh.global_ids[entry.first]);
    domain.weights.push_back(entry.second);
    domain.coordinates.insert(domain.coordinates.end(), point.begin(), point.end());
  }
  return domain;
}

// Adds the elements that this rank owns; number_of: from the local vertex to the node's number.
template <int Dim, class Element, class Numbering>
void addElements(OutputDomain& domain, Mesh<Dim> const& mesh, std::vector<Element> const& elements,
                 Numbering const& number_of)
{
  for (std::size_t number = 0; number < elements.size(); ++number) {
    auto const& element = elements[number];
    if (!isOwned(mesh, element)) {
      continue;
    }
    domain.numbers_in_mesh.push_back(static_cast<int>(number));
    const auto corners = mesh::corners(mesh, element);
    bool wraps = false;
    for (std::size_t k = 0; k < element.size(); ++k) {
      wraps = wraps || corners[k] != mesh.vertices[element[k]];
      domain.connectivity.push_back(number_of(element[k]));
      domain.corners.insert(domain.corners.end(), corners[k].begin(), corners[k].end());
    }
    domain.wraps.push_back(wraps ? 1 : 0);
  }
  domain.is_periodic = mesh.period != Point<Dim>{};
}

// number_of_id: from a global id to the number among all `num_nodes` nodes of the domain.
template <int Dim, class Element>
void number(OutputDomain& domain, Mesh<Dim> const& mesh, std::vector<Element> const& elements,
            GlobalOrdinal num_nodes, std::map<GlobalOrdinal, GlobalOrdinal> const& number_of_id)
{
  domain.num_global_nodes = num_nodes;
  for (const GlobalOrdinal id : domain.vertex_ids) {
    domain.node_numbers.push_back(number_of_id.at(id));
  }
  addElements(domain, mesh, elements,
              [&](int vertex) { return number_of_id.at(mesh.global_ids[vertex]); });
}

void numberAlong(OutputDomain& domain, Mesh<2> const& mesh,
                 std::vector<Mesh<2>::Facet> const& facets, std::vector<GlobalOrdinal> const& order)
{
  std::map<GlobalOrdinal, GlobalOrdinal> number_of_id;
  for (std::size_t i = 0; i < order.size(); ++i) {
    number_of_id[order[i]] = static_cast<GlobalOrdinal>(i);
  }
  number(domain, mesh, facets, static_cast<GlobalOrdinal>(order.size()), number_of_id);
}

// A surface may have many nodes: no rank has the ids of all.
void numberById(OutputDomain& domain, Mesh<3> const& mesh,
                std::vector<Mesh<3>::Facet> const& facets)
{
  std::map<GlobalOrdinal, GlobalOrdinal> number_of_id; // of all nodes of this rank's elements
  for (const GlobalOrdinal id : domain.vertex_ids) {
    number_of_id[id] = 0;
  }
  for (auto const& facet : facets) {
    for (const int vertex : facet) {
      number_of_id[mesh.global_ids[vertex]] = 0;
    }
  }
  std::vector<GlobalOrdinal> asked;
  asked.reserve(number_of_id.size());
  for (auto const& entry : number_of_id) {
    asked.push_back(entry.first);
  }
  const std::vector<GlobalOrdinal> ones(domain.vertex_ids.size(), 1);
  const Directory directory(mesh.num_global_vertices, *domain.comm);
  const auto numbers = directory.sumsBefore(asked, domain.vertex_ids, ones);
  std::size_t i = 0;
  for (auto& entry : number_of_id) {
    entry.second = numbers[i++];
  }
  const auto num_nodes = sumOverRanks(static_cast<GlobalOrdinal>(domain.numOwned()), *domain.comm);
  number(domain, mesh, facets, num_nodes, number_of_id);
}

detail::CurveOrder orderAlong(OutputDomain const& domain, Mesh<2> const& mesh,
                              std::vector<Mesh<2>::Facet> const& facets)
{
  std::vector<GlobalOrdinal> ends;
  for (auto const& facet : facets) {
    if (isOwned(mesh, facet)) {
      ends.push_back(mesh.global_ids[facet[0]]);
      ends.push_back(mesh.global_ids[facet[1]]);
    }
  }
  const auto all_ends = gatherToAll(ends, *domain.comm);
  const auto all_ids = gatherToAll(domain.vertex_ids, *domain.comm);
  const auto all_coordinates = gatherToAll(domain.coordinates, *domain.comm);

  std::vector<detail::Segment> segments;
  for (std::size_t i = 0; i < all_ends.size(); i += 2) {
    segments.push_back({all_ends[i], all_ends[i + 1]});
  }
  std::map<GlobalOrdinal, detail::PlanePoint> coordinates;
  for (std::size_t i = 0; i < all_ids.size(); ++i) {
    coordinates[all_ids[i]] = {all_coordinates[2 * i], all_coordinates[2 * i + 1]};
  }
  return detail::orderCurve(segments, coordinates, domain.start);
}
} // namespace

std::string startText(OutputDomain const& curve)
{
  const std::string start =
    curve.start == CurveStart::upper_end
      ? "its upper end (greater y; of ends equally high the one with smaller x)"
      : "the end with smaller x (of equal x, with smaller y)";
  return start + (curve.parts.empty() ? "" : "; " + partsText(curve));
}

std::string partsText(OutputDomain const& curve)
{
  std::string text;
  for (auto const& part : curve.parts) {
    text += (text.empty() ? "" : ", ") + part.name + ": " + formatShort(part.begin) + " to " +
            formatShort(part.end) + " m";
  }
  return text;
}

std::string partAt(OutputDomain const& curve, double position)
{
  auto const& parts = curve.parts;
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](auto const& part) { return position <= part.end; });
  return found == parts.end() ? "" : found->name;
}

template <int Dim>
OutputDomain boundaryDomain(std::string const& name, Mesh<Dim> const& mesh,
                            std::string const& boundary, RCP<const Communicator> const& comm,
                            CurveStart start)
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
  OutputDomain domain = ownedNodes(name, mesh, facets, comm);
  domain.start = start;
  const double nodes = sumOverRanks(static_cast<double>(domain.numOwned()), *comm);
  ASPERITY_REQUIRE(nodes > 0, "The boundary '" << boundary << "', to be the " << name
                                               << ", has no facets. Check the mesh.");
  if constexpr (Dim == 2) {
    const detail::CurveOrder order = orderAlong(domain, mesh, facets);
    numberAlong(domain, mesh, facets, order.vertex_ids);
    for (const GlobalOrdinal node : domain.node_numbers) {
      domain.positions.push_back(order.positions[node]);
    }
  } else {
    numberById(domain, mesh, facets);
  }
  return domain;
}

namespace
{
template <int Dim>
void addParts(OutputDomain& curve, Mesh<Dim> const& mesh,
              std::vector<std::string> const& boundaries)
{
  std::map<int, double> position_of;
  for (std::size_t i = 0; i < curve.numOwned(); ++i) {
    position_of[curve.vertices[i]] = curve.positions[i];
  }
  for (auto const& name : boundaries) {
    double begin = std::numeric_limits<double>::infinity(), end = -begin;
    for (auto const& facet : mesh.boundaries.at(name)) {
      for (const int vertex : facet) {
        const auto found = position_of.find(vertex);
        if (found != position_of.end()) {
          begin = std::min(begin, found->second);
          end = std::max(end, found->second);
        }
      }
    }
    curve.parts.push_back({name, minOverRanks(begin, *curve.comm), maxOverRanks(end, *curve.comm)});
  }
  std::sort(curve.parts.begin(), curve.parts.end(),
            [](auto const& left, auto const& right) { return left.begin < right.begin; });
}
} // namespace

template <int Dim>
void nameParts(OutputDomain& domain, Mesh<Dim> const& mesh,
               std::vector<std::string> const& boundaries)
{
  if (boundaries.size() < 2) {
    return;
  }
  domain.boundaries = boundaries;
  std::map<int, int> first_of_vertex;
  std::vector<int> ends; // of the facets of each boundary among all
  for (std::size_t b = 0; b < boundaries.size(); ++b) {
    auto const& facets = mesh.boundaries.at(boundaries[b]);
    ends.push_back((ends.empty() ? 0 : ends.back()) + static_cast<int>(facets.size()));
    for (auto const& facet : facets) {
      for (const int vertex : facet) {
        first_of_vertex.emplace(vertex, static_cast<int>(b));
      }
    }
  }
  for (const int vertex : domain.vertices) {
    domain.node_boundaries.push_back(first_of_vertex.at(vertex));
  }
  for (const int facet : domain.numbers_in_mesh) {
    const auto end = std::upper_bound(ends.begin(), ends.end(), facet);
    domain.element_boundaries.push_back(static_cast<int>(end - ends.begin()));
  }
  if (domain.isCurve()) {
    addParts(domain, mesh, boundaries);
  }
}

template <int Dim>
OutputDomain volumeDomain(Mesh<Dim> const& mesh, RCP<const Communicator> const& comm)
{
  OutputDomain domain = ownedNodes("volume", mesh, mesh.cells, comm);
  domain.num_global_nodes = mesh.num_global_vertices;
  domain.node_numbers = domain.vertex_ids; // every vertex is in a cell: no count is needed
  addElements(domain, mesh, mesh.cells, [&](int vertex) { return mesh.global_ids[vertex]; });
  return domain;
}

template OutputDomain boundaryDomain(std::string const&, Mesh<2> const&, std::string const&,
                                     RCP<const Communicator> const&, CurveStart);
template OutputDomain boundaryDomain(std::string const&, Mesh<3> const&, std::string const&,
                                     RCP<const Communicator> const&, CurveStart);
template void nameParts(OutputDomain&, Mesh<2> const&, std::vector<std::string> const&);
template void nameParts(OutputDomain&, Mesh<3> const&, std::vector<std::string> const&);
template OutputDomain volumeDomain(Mesh<2> const&, RCP<const Communicator> const&);
template OutputDomain volumeDomain(Mesh<3> const&, RCP<const Communicator> const&);
} // namespace asperity::io
