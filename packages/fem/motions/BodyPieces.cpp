#include "fem/motions/BodyPieces.hpp"

#include "base/DisjointSets.hpp"
#include "base/parallel/GhostExchange.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/PointText.hpp"
#include "mesh/TouchingFacets.hpp"

#include <Tpetra_Map.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace asperity::fem
{
namespace
{
// The cells at each owned vertex: those of vertex v stand from first[v] to first[v + 1].
struct Stars
{
  std::vector<std::size_t> first;
  std::vector<int> cells;
};

template <int Dim>
Stars starsOf(Mesh<Dim> const& mesh)
{
  Stars stars;
  stars.first.assign(static_cast<std::size_t>(mesh.num_owned) + 1, 0);
  for (auto const& cell : mesh.cells) {
    for (const int v : cell) {
      if (v < mesh.num_owned) {
        ++stars.first[v + 1];
      }
    }
  }
  std::partial_sum(stars.first.begin(), stars.first.end(), stars.first.begin());
  stars.cells.resize(stars.first.back());
  auto next = stars.first;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const int v : mesh.cells[c]) {
      if (v < mesh.num_owned) {
        stars.cells[next[v]++] = static_cast<int>(c);
      }
    }
  }
  return stars;
}

// The vertices of one place on all sides of its faults are one set.
template <int Dim>
DisjointSets placesOf(Mesh<Dim> const& mesh)
{
  DisjointSets places(mesh.vertices.size());
  for (auto const& pair : mesh.splits) {
    places.join(pair.plus, pair.minus);
  }
  return places;
}

// Whether the cells at a vertex are not all connected by facets that contain the vertex. A facet of
// a fault connects its two sides: where a fault branches off another one, nothing else connects the
// cells that meet at the tip.
template <int Dim>
bool isPinched(Mesh<Dim> const& mesh, DisjointSets& places, int vertex, int const* begin,
               int const* end)
{
  using Key = std::array<int, Dim - 1>; // the other vertices of a facet
  std::vector<std::pair<Key, int>> facets;
  for (int const* cell = begin; cell != end; ++cell) {
    auto const& corners = mesh.cells[*cell];
    for (const int left_out : corners) {
      if (left_out == vertex) {
        continue;
      }
      Key key{};
      auto place = key.begin();
      for (const int v : corners) {
        if (v != vertex && v != left_out) {
          *place++ = static_cast<int>(places.find(v));
        }
      }
      std::sort(key.begin(), key.end());
      facets.push_back({key, static_cast<int>(cell - begin)});
    }
  }
  std::sort(facets.begin(), facets.end());
  auto num_groups = end - begin;
  DisjointSets groups(static_cast<std::size_t>(num_groups));
  for (std::size_t i = 1; i < facets.size(); ++i) {
    auto const& [before, one] = facets[i - 1];
    auto const& [key, other] = facets[i];
    if (before == key && groups.find(one) != groups.find(other)) {
      groups.join(one, other);
      --num_groups;
    }
  }
  return num_groups > 1;
}

GhostExchange exchangeOf(std::vector<GlobalOrdinal> const& ids, int num_owned,
                         RCP<const Communicator> const& communicator)
{
  const auto none = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const Teuchos::ArrayView<GlobalOrdinal const> all(ids.data(), ids.size());
  const Map owned(none, all.view(0, num_owned), 0, communicator);
  return GhostExchange(owned, {ids.begin() + num_owned, ids.end()});
}

// Every vertex gets the largest of the numbers that ranks have for it.
void takeLargest(GhostExchange const& exchange, std::vector<double>& numbers)
{
  const auto values = toDevice(numbers, "asperity::fem::numbersOfVertices");
  exchange.gatherLargest<double>(values, values);
  exchange.share(values);
  numbers = toVector(values);
}

// (num_local) 1 at pinched vertices, ghosts too, else 0.
template <int Dim>
std::vector<double> pinchedVertices(Mesh<Dim> const& mesh, GhostExchange const& exchange)
{
  const auto stars = starsOf(mesh);
  int const* const cells = stars.cells.data();
  auto places = placesOf(mesh);
  std::vector<double> is_pinched(mesh.vertices.size(), 0);
  for (int v = 0; v < mesh.num_owned; ++v) {
    int const* const begin = cells + stars.first[v];
    is_pinched[v] = isPinched(mesh, places, v, begin, cells + stars.first[v + 1]) ? 1 : 0;
  }
  takeLargest(exchange, is_pinched);
  return is_pinched;
}

// The connected vertices of this rank. Pinched vertices connect nothing.
template <int Dim>
DisjointSets localPieces(Mesh<Dim> const& mesh, std::vector<double> const& is_pinched)
{
  DisjointSets pieces(mesh.vertices.size());
  for (auto const& cell : mesh.cells) {
    int first = -1;
    for (const int v : cell) {
      if (is_pinched[v] == 0) {
        pieces.join(first < 0 ? v : first, v);
        first = v;
      }
    }
  }
  for (auto const& pair : mesh.splits) {
    if (is_pinched[pair.plus] == 0 && is_pinched[pair.minus] == 0) {
      pieces.join(pair.plus, pair.minus);
    }
  }
  return pieces;
}

// (num_local) the largest global id in each vertex's piece, plus one. Ranks exchange the labels
// until none changes.
template <int Dim>
std::vector<double> largestIds(Mesh<Dim> const& mesh, DisjointSets pieces,
                               GhostExchange const& exchange, Communicator const& communicator)
{
  std::vector<double> labels;
  for (const GlobalOrdinal id : mesh.global_ids) {
    labels.push_back(static_cast<double>(id + 1));
  }
  for (int has_changed = 1; has_changed == 1;) {
    const auto before = labels;
    auto largest = labels;
    for (std::size_t v = 0; v < labels.size(); ++v) {
      double& of_piece = largest[pieces.find(v)];
      of_piece = std::max(of_piece, labels[v]);
    }
    for (std::size_t v = 0; v < labels.size(); ++v) {
      labels[v] = largest[pieces.find(v)];
    }
    takeLargest(exchange, labels);
    has_changed = maxOverRanks(labels != before ? 1 : 0, communicator);
  }
  return labels;
}
} // namespace

template <int Dim>
BodyPieces<Dim> bodyPieces(Mesh<Dim> const& mesh, RCP<const Communicator> const& communicator)
{
  const auto exchange = exchangeOf(mesh.global_ids, mesh.num_owned, communicator);
  const auto is_pinched = pinchedVertices(mesh, exchange);
  const auto labels = largestIds(mesh, localPieces(mesh, is_pinched), exchange, *communicator);
  constexpr auto none = std::numeric_limits<GlobalOrdinal>::max();
  BodyPieces<Dim> result;
  GlobalOrdinal first = none;
  Point<Dim> place{};
  for (int v = 0; v < mesh.num_owned; ++v) {
    const GlobalOrdinal id = mesh.global_ids[v];
    result.labels.push_back(is_pinched[v] == 0 ? static_cast<GlobalOrdinal>(labels[v]) - 1 : -1);
    if (is_pinched[v] == 0) {
      result.num_pieces += labels[v] == static_cast<double>(id + 1) ? 1 : 0;
      continue;
    }
    ++result.num_pinched;
    if (id < first) {
      first = id;
      place = mesh.vertices[v];
    }
  }
  result.num_pieces = sumOverRanks(result.num_pieces, *communicator);
  result.num_pinched = sumOverRanks(result.num_pinched, *communicator);
  const auto least = minOverRanks(first, *communicator);
  if (result.num_pinched > 0) {
    result.first_pinched = least;
    // Only the rank that owns the vertex adds its place to the sum.
    result.place = sumOverRanks(first == least ? place : Point<Dim>{}, *communicator);
  }
  return result;
}

template <int Dim>
GlobalOrdinal BodyPieces<Dim>::nextPiece(GlobalOrdinal above,
                                         Communicator const& communicator) const
{
  GlobalOrdinal least = std::numeric_limits<GlobalOrdinal>::max();
  for (const GlobalOrdinal label : labels) {
    least = label > above ? std::min(least, label) : least;
  }
  return minOverRanks(least, communicator);
}

template <int Dim>
std::vector<Warning> warnOfPieces(Mesh<Dim> const& mesh,
                                  RCP<const Communicator> const& communicator)
{
  const auto pieces = bodyPieces(mesh, communicator);
  std::vector<Warning> warnings;
  if (pieces.num_pinched > 0) {
    warnings.push_back({"cells that touch",
                        "at " + std::to_string(pieces.num_pinched) +
                          (pieces.num_pinched == 1 ? " vertex" : " vertices") +
                          " cells meet that share no " + (Dim == 2 ? "edge" : "face") +
                          " there, as in a bow tie; the first is vertex " +
                          std::to_string(pieces.first_pinched) + " at " + mesh::text(pieces.place) +
                          " m. Nothing but the vertex holds the body together. Check the mesh."});
  }
  if (pieces.num_pieces > 1) {
    const auto touching = mesh::touchingFacets(mesh, *communicator);
    warnings.push_back({"pieces", "the body consists of " + std::to_string(pieces.num_pieces) +
                                    " pieces that share no " + (Dim == 2 ? "edge" : "face") +
                                    " and no fault. Each moves by itself. " +
                                    (touching ? mesh::sentence(*touching) : "Check the mesh.")});
  }
  return warnings;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template struct BodyPieces<Dim>;                                                                 \
  template BodyPieces<Dim> bodyPieces(Mesh<Dim> const&, RCP<const Communicator> const&);           \
  template std::vector<Warning> warnOfPieces(Mesh<Dim> const&, RCP<const Communicator> const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::fem
