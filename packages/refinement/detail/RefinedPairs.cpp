#include "refinement/detail/RefinedPairs.hpp"

#include "base/parallel/Messages.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <unordered_map>

namespace asperity::refinement::detail
{
namespace
{
// The pairs of midpoints that this rank owns, by the global ids of both points.
class OwnedPairs
{
public:
  struct Row
  {
    GlobalOrdinal plus, minus;
    int kind;
  };

  template <int Dim>
  OwnedPairs(FaultEdges<Dim> const& faults, Points<Dim> const& points, int rank)
  {
    for (auto const& pair : faults.pairs()) {
      auto const &plus = pair.plus, &minus = pair.minus;
      const int above = points.midpoint(plus[0], plus[1]);
      if (points.owner(above) == rank) {
        const int below = points.midpoint(minus[0], minus[1]);
        at_.emplace(points.id(above), rows_.size());
        at_.emplace(points.id(below), rows_.size());
        rows_.push_back({points.id(above), points.id(below), mesh::kindOf(pair)});
      }
    }
  }

  // All pairs at the place of this point: at a branch a point is in two of them.
  std::vector<Row> around(GlobalOrdinal id) const
  {
    std::set<std::size_t> found;
    std::vector<GlobalOrdinal> ids = {id};
    for (std::size_t next = 0; next < ids.size(); ++next) {
      const auto [first, last] = at_.equal_range(ids[next]);
      for (auto entry = first; entry != last; ++entry) {
        if (found.insert(entry->second).second) {
          ids.push_back(rows_[entry->second].plus);
          ids.push_back(rows_[entry->second].minus);
        }
      }
    }
    std::vector<Row> result;
    result.reserve(found.size());
    for (const std::size_t row : found) {
      result.push_back(rows_[row]);
    }
    return result;
  }

private:
  std::vector<Row> rows_;
  std::unordered_multimap<GlobalOrdinal, std::size_t> at_;
};

// The pairs of the coarse part, which has either both vertices of a pair or none.
template <int Dim>
std::vector<SplitVertex> coarsePairs(std::vector<char>& needed, Mesh<Dim> const& coarse)
{
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (auto const& [plus, minus, is_tip, is_joint] : coarse.splits) {
      has_grown = has_grown || needed[plus] != needed[minus];
      needed[plus] = needed[minus] = needed[plus] || needed[minus] ? 1 : 0;
    }
  }
  std::vector<SplitVertex> pairs;
  std::copy_if(coarse.splits.begin(), coarse.splits.end(), std::back_inserter(pairs),
               [&](SplitVertex const& pair) { return needed[pair.plus] != 0; });
  return pairs;
}
} // namespace

template <int Dim>
std::vector<SplitVertex> pairsOf(std::vector<char>& needed, Mesh<Dim> const& coarse,
                                 FaultEdges<Dim> const& faults, Points<Dim>& points,
                                 Communicator const& communicator)
{
  if (coarse.faults.empty()) { // on all ranks
    return {};
  }
  auto pairs = coarsePairs(needed, coarse);
  const OwnedPairs owned(faults, points, communicator.getRank());
  std::vector<int> asked, owners;
  Rows questions;
  std::unordered_map<GlobalOrdinal, int> point_of_id;
  for (int point = 0; point < points.size(); ++point) {
    const Edge ends = points.parents(point);
    if (points.isMidpoint(point) && faults.isOfPair(ends[0]) && faults.isOfPair(ends[1])) {
      point_of_id.emplace(points.id(point), point);
      if (needed[point]) {
        asked.push_back(point);
        owners.push_back(points.owner(point));
        questions.push_back(points.id(point));
      }
    }
  }
  const auto answer = [&](GlobalOrdinal const* id, Rows& reply) {
    for (auto const& row : owned.around(*id)) {
      reply.insert(reply.end(), {row.plus, row.minus, row.kind});
    }
  };
  const Rows rows = ask(questions, 1, owners, 3, answer, communicator);
  const auto point_of = [&](GlobalOrdinal id, int twin) {
    const auto known = point_of_id.find(id);
    const int point = known != point_of_id.end() ? known->second : points.add(id, twin);
    point_of_id.emplace(id, point);
    needed.resize(static_cast<std::size_t>(points.size()), 0);
    needed[point] = 1;
    return point;
  };
  std::set<GlobalOrdinal> known_plus;
  for (std::size_t i = 0; i < rows.size(); i += 4) {
    const int twin = asked[static_cast<std::size_t>(rows[i])];
    const int plus = point_of(rows[i + 1], twin), minus = point_of(rows[i + 2], twin);
    if (known_plus.insert(rows[i + 1]).second) {
      pairs.push_back(mesh::splitVertex(plus, minus, static_cast<int>(rows[i + 3])));
    }
  }
  return pairs;
}

template std::vector<SplitVertex> pairsOf(std::vector<char>&, Mesh<2> const&, FaultEdges<2> const&,
                                          Points<2>&, Communicator const&);
template std::vector<SplitVertex> pairsOf(std::vector<char>&, Mesh<3> const&, FaultEdges<3> const&,
                                          Points<3>&, Communicator const&);
} // namespace asperity::refinement::detail
