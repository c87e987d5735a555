#include "refinement/detail/Points.hpp"

#include "base/parallel/Directory.hpp"
#include "base/parallel/Messages.hpp"
#include "base/parallel/Reductions.hpp"

#include <numeric>

namespace asperity::refinement::detail
{
namespace
{
// Scatters the bits of two ids, so that neither end is favoured where ids follow a pattern.
bool isOdd(GlobalOrdinal a, GlobalOrdinal b)
{
  auto bits = static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15u;
  bits = (bits ^ (bits >> 29) ^ static_cast<std::uint64_t>(b)) * 0xBF58476D1CE4E5B9u;
  return ((bits ^ (bits >> 32)) & 1) != 0;
}
} // namespace

template <int Dim>
std::vector<GlobalOrdinal> idsOfPlaces(Mesh<Dim> const& part)
{
  auto ids = part.global_ids;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (auto const& [plus, minus, is_tip, is_joint] : part.splits) {
      const auto least = std::min(ids[plus], ids[minus]);
      has_changed = has_changed || ids[plus] != least || ids[minus] != least;
      ids[plus] = ids[minus] = least;
    }
  }
  return ids;
}

template <int Dim>
Points<Dim>::Points(OwnedPart<Dim> const& coarse, PartEdges<Dim> const& edges,
                    Communicator const& communicator)
    : part_(coarse.mesh)
    , edges_(edges)
    , coarse_owners_(coarse.owners)
    , num_coarse_(static_cast<int>(part_.vertices.size()))
    , ids_(part_.global_ids)
    , owners_(coarse.owners)
{
  parents_.reserve(ids_.size() + static_cast<std::size_t>(edges.size()));
  for (int v = 0; v < num_coarse_; ++v) {
    parents_.push_back({v, v});
  }
  for (int v = 0; v < num_coarse_; ++v) {
    for (int e = edges.begin(v); e < edges.begin(v + 1); ++e) {
      parents_.push_back({v, edges.second(e)});
    }
  }
  number(communicator);
  chooseOwners();
}

// The owner of an edge's first end has all edges with this first end, and numbers them.
template <int Dim>
void Points<Dim>::number(Communicator const& communicator)
{
  std::vector<GlobalOrdinal> counts;
  counts.reserve(static_cast<std::size_t>(part_.num_owned));
  for (int v = 0; v < part_.num_owned; ++v) {
    counts.push_back(edges_.begin(v + 1) - edges_.begin(v));
  }
  const std::vector<GlobalOrdinal> owned(ids_.begin(), ids_.begin() + part_.num_owned);
  const auto before =
    Directory(part_.num_global_vertices, communicator).sumsBefore(owned, owned, counts);
  num_global_ =
    part_.num_global_vertices +
    sumOverRanks(std::accumulate(counts.begin(), counts.end(), GlobalOrdinal(0)), communicator);
  ids_.resize(parents_.size(), -1);
  for (int v = 0; v < part_.num_owned; ++v) {
    for (int e = edges_.begin(v); e < edges_.begin(v + 1); ++e) {
      ids_[num_coarse_ + e] = part_.num_global_vertices + before[v] + (e - edges_.begin(v));
    }
  }
  // A question is a row of two global ids, the ends of an edge between ghosts; the answer is the id
  // of its midpoint.
  const int first_asked = num_coarse_ + edges_.begin(part_.num_owned);
  Rows questions;
  std::vector<int> destinations;
  for (int point = first_asked; point < size(); ++point) {
    const auto [first, second] = parents_[point];
    questions.insert(questions.end(), {ids_[first], ids_[second]});
    destinations.push_back(coarse_owners_[first]);
  }
  const auto answer = [this](GlobalOrdinal const* ends, Rows& reply) {
    reply.push_back(id(midpoint(localVertex(part_, ends[0]), localVertex(part_, ends[1]))));
  };
  const Rows rows = ask(questions, 2, destinations, 1, answer, communicator);
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    ids_[static_cast<std::size_t>(first_asked + rows[i])] = rows[i + 1];
  }
}

template <int Dim>
void Points<Dim>::chooseOwners()
{
  const auto places = idsOfPlaces(part_);
  owners_.reserve(parents_.size());
  for (std::size_t point = owners_.size(); point < parents_.size(); ++point) {
    auto [a, b] = parents_[point];
    if (places[b] < places[a]) {
      std::swap(a, b);
    }
    owners_.push_back(coarse_owners_[isOdd(places[a], places[b]) ? b : a]);
  }
}

template <int Dim>
Point<Dim> Points<Dim>::coordinates(int point) const
{
  const Edge edge = parents(point);
  if (edge[0] == edge[1]) {
    return part_.vertices[edge[0]];
  }
  const auto ends = mesh::corners(part_, edge); // next to each other, also across a period
  Point<Dim> result;
  for (int d = 0; d < Dim; ++d) {
    result[d] = 0.5 * (ends[0][d] + ends[1][d]);
  }
  return result;
}

template <int Dim>
int Points<Dim>::add(GlobalOrdinal id, int twin)
{
  const Edge parents = parents_[static_cast<std::size_t>(twin)];
  const int owner = owners_[static_cast<std::size_t>(twin)];
  ids_.push_back(id);
  owners_.push_back(owner);
  parents_.push_back(parents);
  return size() - 1;
}

template std::vector<GlobalOrdinal> idsOfPlaces(Mesh<2> const&);
template std::vector<GlobalOrdinal> idsOfPlaces(Mesh<3> const&);
template class Points<2>;
template class Points<3>;
} // namespace asperity::refinement::detail
