#include "refinement/detail/FaultEdges.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "refinement/detail/RedRule.hpp"

#include <set>

namespace asperity::refinement::detail
{
using mesh::detail::sorted;

template <int Dim>
FaultEdges<Dim>::FaultEdges(Mesh<Dim> const& part, std::string const& where)
    : part_(part)
    , where_(where)
    , sides_(part)
    , has_pair_(part.vertices.size(), false)
    , is_minus_of_tip_(part.vertices.size(), false)
{
  markPairs();
  collectEdges();
  findRings();
  decideEdgesOfTips();
  sortPairs();
}

template <int Dim>
void FaultEdges<Dim>::markPairs()
{
  for (auto const& [plus, minus, is_tip, is_joint] : part_.splits) {
    has_pair_[plus] = has_pair_[minus] = true;
    is_minus_of_tip_[minus] = is_minus_of_tip_[minus] || is_tip;
  }
}

template <int Dim>
void FaultEdges<Dim>::collectEdges()
{
  for (auto const& fault : part_.faults) {
    for (auto const& facet : part_.boundaries.at(fault)) {
      addFacet(fault, facet);
    }
  }
}

// Each edge between tips is cut by its own fault or by none. On an edge that another fault has cut
// already, it is a branch, which may cut the cells on its side once more.
template <int Dim>
void FaultEdges<Dim>::decideEdgesOfTips()
{
  std::set<Edge> opened; // by another fault
  for (auto const& pair : pairs_) {
    opened.insert(pair.plus);
    opened.insert(pair.minus);
  }
  requireNoCrossing();
  for (auto const& [edge, facets] : tip_facets_) {
    if (!isOwned(edge)) {
      continue;
    }
    const bool is_of_other_fault = opened.count(edge) > 0;
    if (Dim == 3 || !is_of_other_fault) { // in the plane the edge is the facet of one fault
      decideCut(edge, facets, is_of_other_fault);
    }
    const bool is_cut = cuts_.count(edge) > 0;
    for (auto const& facet : facets) {
      pairs_.push_back({sorted(facet.plus), edge, !is_cut, is_cut && is_of_other_fault});
    }
  }
}

// A fault that has facets on both sides of an edge of another one crosses it there. Between two
// tips on one side, the edges of cells do not tell the copies apart.
template <int Dim>
void FaultEdges<Dim>::requireNoCrossing() const
{
  for (auto const& pair : pairs_) {
    for (auto const& [tips, others] :
         {std::make_pair(pair.plus, pair.minus), std::make_pair(pair.minus, pair.plus)}) {
      const auto found = tip_facets_.find(tips);
      const auto open = open_to_.find(others);
      for (std::size_t i = 0; found != tip_facets_.end() && i < found->second.size(); ++i) {
        auto const& fault = *found->second[i].fault;
        if (open != open_to_.end() && open->second.count(fault) > 0) {
          refuseCopies(tips, fault);
        }
      }
    }
  }
}

template <int Dim>
void FaultEdges<Dim>::refuseCopies(Edge const& edge, std::string const& fault) const
{
  throw InputError(where_ + ": fault '" + fault +
                   "' meets itself or another one between two tips, at " +
                   mesh::text(mesh::centroid(mesh::corners(part_, edge))) +
                   ", where a new vertex would need more than two copies. Refine the mesh there "
                   "before it is split, with a smaller cell size.");
}

// Whether a fault whose facets have this edge may end along it at another fault with a joint. Where
// it does so at an end of the edge and crosses the other one at the other end, it crosses it along
// the edge.
template <int Dim>
bool FaultEdges<Dim>::mayHaveJoint(int first, int second) const
{
  const auto is_joint = [this](int plus) {
    auto const* pair = sides_.find(plus);
    return pair && pair->is_joint;
  };
  return (is_joint(first) || is_joint(second)) && !sides_.isAtCrossing(first) &&
         !sides_.isAtCrossing(second);
}

// Finds the joints among the pairs that may be some: the others lie inside a branch, not along the
// fault at which it ends.
template <int Dim>
void FaultEdges<Dim>::findJoints()
{
  std::set<Edge> of_main;
  for (auto const& pair : pairs_) {
    if (!pair.is_tip && !pair.is_joint) {
      of_main.insert(pair.plus);
      of_main.insert(pair.minus);
    }
  }
  for (auto& pair : pairs_) {
    pair.is_joint =
      pair.is_joint && (of_main.count(pair.plus) > 0 || of_main.count(pair.minus) > 0);
    if (pair.is_joint) {
      joints_.emplace(pair.plus, pair);
    }
  }
}

// The copy of an edge that the cells would have without the branch that ends along it.
template <int Dim>
Edge FaultEdges<Dim>::withoutJoint(Edge const& edge) const
{
  const auto joint = joints_.find(edge);
  return joint == joints_.end() ? edge : joint->second.minus;
}

// Each once. On the plus side of both faults that cross along an edge, each fault has another copy
// on its minus side. Both of these have a pair with the fourth copy. Where a branch ends along the
// edge, the pair of the fault that goes on is the same on both sides of it.
template <int Dim>
void FaultEdges<Dim>::sortPairs()
{
  findJoints();
  std::map<Edge, std::set<std::pair<Edge, bool>>> minus_of; // with is_tip, by plus
  for (auto const& pair : pairs_) {
    if (!pair.is_joint) {
      minus_of[withoutJoint(pair.plus)].insert({withoutJoint(pair.minus), pair.is_tip});
    }
  }
  pairs_.clear();
  for (auto const& joint : joints_) {
    pairs_.push_back(joint.second);
  }
  const auto minusOf = [&minus_of](Edge const& plus) {
    const auto found = minus_of.find(plus);
    return found == minus_of.end() ? Edge{-1, -1} : found->second.begin()->first;
  };
  for (auto const& [plus, found] : minus_of) {
    auto [minus, is_tip] = *found.begin();
    if (found.size() > 1) {
      minus = minusOf(minus);
      if (found.size() > 2 || is_tip || minus[0] < 0 || minus != minusOf(found.rbegin()->first)) {
        refuseCopies(plus, *open_to_.at(plus).begin());
      }
    }
    pairs_.push_back({plus, minus, is_tip});
  }
}

template <int Dim>
void FaultEdges<Dim>::addFacet(std::string const& fault, Facet const& facet)
{
  const auto plus_facet = sides_.plusSide(facet), minus_facet = sides_.minusSide(facet);
  for (auto const& [i, j] : FacetRule<Dim>::edges) {
    const Edge plus_edge = sorted(Edge{plus_facet[i], plus_facet[j]}),
               minus_edge = sorted(Edge{minus_facet[i], minus_facet[j]});
    open_to_[plus_edge].insert(fault);
    if (plus_edge != minus_edge) {
      if (isOwned(plus_edge)) {
        pairs_.push_back({plus_edge, minus_edge, false, mayHaveJoint(facet[i], facet[j])});
      }
      open_to_[minus_edge].insert(fault);
    } else {
      const Edge plus{facet[i], facet[j]};
      edges_of_tips_.push_back(plus);
      tip_facets_[plus_edge].push_back({&fault, facet, plus});
    }
  }
}

template <int Dim>
void FaultEdges<Dim>::findRings()
{
  if (part_.faults.empty()) {
    return;
  }
  for (std::size_t c = 0; c < part_.cells.size(); ++c) {
    auto const& cell = part_.cells[c];
    for (auto const& [i, j] : RedRule<Dim>::edges) {
      if (is_minus_of_tip_[cell[i]] && is_minus_of_tip_[cell[j]]) {
        rings_[sorted(Edge{cell[i], cell[j]})].push_back(static_cast<int>(c));
      }
    }
  }
}

// The set of the cell that has this facet, or -1. The facet looks out of its plus side.
template <int Dim>
int FaultEdges<Dim>::cellSetOn(Star const& star, typename Star::Sets const& sets,
                               Facet const& facet, bool plus_side) const
{
  const auto side = plus_side ? sides_.plusSide(facet) : sides_.minusSide(facet);
  const auto corners = mesh::corners(part_, side);
  for (std::size_t i = 0; i < star.cells().size(); ++i) {
    auto const& cell = part_.cells[star.cells()[i]];
    const auto inward =
      mesh::difference<Dim>(mesh::centroid(mesh::corners(part_, cell)), mesh::centroid(corners));
    const bool is_plus = mesh::dot<Dim>(inward, mesh::areaNormal(corners)) < 0.0;
    if (hasVertices(cell, side) && is_plus == plus_side) {
      return sets.set_of_cell[i];
    }
  }
  return -1;
}

template <int Dim>
void FaultEdges<Dim>::decideCut(Edge const& edge, std::vector<TipFacet> const& facets,
                                bool is_of_other_fault)
{
  std::set<Facet> of_faults;
  for (auto const& each : facets) {
    of_faults.insert(sorted(sides_.plusSide(each.facet)));
    of_faults.insert(sorted(sides_.minusSide(each.facet)));
  }
  const Star star(part_.cells, rings_.at(edge), edge,
                  [&](Facet const& facet) { return of_faults.count(facet) > 0 ? 0 : -1; });
  const auto sets = star.cut([](int) { return true; });
  std::set<int> plus, minus;
  std::set<Edge> plus_edges;
  for (auto const& each : facets) {
    plus.insert(cellSetOn(star, sets, each.facet, true));
    minus.insert(cellSetOn(star, sets, each.facet, false));
    plus_edges.insert(sorted(each.plus));
  }
  ASPERITY_ASSERT(plus.count(-1) == 0 && minus.count(-1) == 0);
  if (sets.count == 1) {
    return; // a fault ends here
  }
  if (sets.count > 2 || plus.size() > 1 || minus.size() > 1 || plus == minus ||
      plus_edges.size() > 1) {
    if (is_of_other_fault) {
      return; // branches that end here with tips
    }
    refuseCopies(edge, *facets.front().fault);
  }
  auto& cut = cuts_[edge];
  cut.plus = *plus_edges.begin();
  for (std::size_t i = 0; i < star.cells().size(); ++i) {
    if (sets.set_of_cell[i] == *plus.begin()) {
      cut.plus_cells.push_back(star.cells()[i]);
    }
  }
}

template <int Dim>
std::array<Edge, 2> FaultEdges<Dim>::copiesOfEdge(Facet const& facet, int i, int j) const
{
  const auto plus_facet = sides_.plusSide(facet), minus_facet = sides_.minusSide(facet);
  const Edge plus{plus_facet[i], plus_facet[j]}, minus{minus_facet[i], minus_facet[j]};
  if (plus == minus) {
    return {Edge{facet[i], facet[j]}, Edge{facet[i], facet[j]}};
  }
  return {plus, minus};
}

template class FaultEdges<2>;
template class FaultEdges<3>;
} // namespace asperity::refinement::detail
