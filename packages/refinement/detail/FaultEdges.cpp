#include "refinement/detail/FaultEdges.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/FacetTable.hpp"
#include "refinement/detail/RedRule.hpp"

#include <set>

namespace asperity::refinement::detail
{
namespace
{
using mesh::detail::sorted;

template <std::size_t N>
bool contains(std::array<int, N> const& simplex, int vertex)
{
  return std::find(simplex.begin(), simplex.end(), vertex) != simplex.end();
}

// The vertices of a cell or a facet that the edge does not have; in the plane a facet has none, and
// the edge itself is what its cells have in common: -1.
template <std::size_t N>
std::vector<int> besides(std::array<int, N> const& simplex, Edge const& edge, int dim)
{
  std::vector<int> result;
  for (int vertex : simplex) {
    if (!contains(edge, vertex)) {
      result.push_back(vertex);
    }
  }
  return dim == 2 ? std::vector<int>{-1} : result;
}
} // namespace

// The cells around an edge, each with the number of the set into which it falls.
template <int Dim>
struct FaultEdges<Dim>::Labels
{
  std::vector<int> cells;
  std::vector<int> labels;

  std::size_t count() const { return std::set<int>(labels.begin(), labels.end()).size(); }
};

template <int Dim>
FaultEdges<Dim>::FaultEdges(Mesh<Dim> const& part, std::string const& where)
    : part_(part)
    , where_(where)
    , sides_(part.splits)
    , has_pair_(part.vertices.size(), false)
    , is_below_tip_(part.vertices.size(), false)
{
  for (auto const& [plus, minus, is_tip] : part.splits) {
    has_pair_[plus] = has_pair_[minus] = true;
    is_below_tip_[minus] = is_below_tip_[minus] || is_tip;
  }
  for (auto const& fault : part.faults) {
    for (auto const& facet : part.boundaries.at(fault)) {
      addFacet(fault, facet);
    }
  }
  findRings();
  std::set<Edge> opened; // where another fault cuts
  for (auto const& pair : pairs_) {
    opened.insert(pair.plus);
    opened.insert(pair.minus);
  }
  for (auto const& [edge, facets] : tip_facets_) {
    if (!isOwned(edge)) {
      continue;
    }
    if (opened.count(edge) == 0) {
      decide(edge, facets);
    }
    for (auto const& facet : facets) {
      pairs_.push_back({sorted(facet.plus), edge, cuts_.count(edge) == 0});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(),
            [](auto const& a, auto const& b) { return a.plus < b.plus; });
  const auto end = std::unique(pairs_.begin(), pairs_.end(),
                               [](auto const& a, auto const& b) { return a.plus == b.plus; });
  pairs_.erase(end, pairs_.end());
}

template <int Dim>
void FaultEdges<Dim>::addFacet(std::string const& fault, Facet const& facet)
{
  const auto up = sides_.plusSide(facet), down = sides_.minusSide(facet);
  for (auto const& [i, j] : FacetRule<Dim>::edges) {
    const Edge above = sorted(Edge{up[i], up[j]}), below = sorted(Edge{down[i], down[j]});
    if (above != below) {
      if (isOwned(above)) {
        pairs_.push_back({above, below, false});
      }
    } else {
      const Edge plus{facet[i], facet[j]};
      edges_of_tips_.push_back(plus);
      tip_facets_[above].push_back({&fault, facet, plus});
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
      if (is_below_tip_[cell[i]] && is_below_tip_[cell[j]]) {
        rings_[sorted(Edge{cell[i], cell[j]})].push_back(static_cast<int>(c));
      }
    }
  }
}

// Neighbours in the ring have one set unless the facet between them belongs to a fault.
template <int Dim>
typename FaultEdges<Dim>::Labels
FaultEdges<Dim>::labelsAround(Edge const& edge, std::vector<TipFacet> const& facets) const
{
  std::set<int> blocked;
  for (auto const& each : facets) {
    for (auto const& side : {sides_.plusSide(each.facet), sides_.minusSide(each.facet)}) {
      const auto others = besides(side, edge, Dim);
      blocked.insert(others.begin(), others.end());
    }
  }
  Labels result;
  result.cells = rings_.at(edge);
  std::map<int, int> label_of_link;
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    const auto mine = static_cast<int>(i);
    result.labels.push_back(mine);
    for (int link : besides(part_.cells[result.cells[i]], edge, Dim)) {
      if (blocked.count(link) > 0) {
        continue;
      }
      const auto [known, is_new] = label_of_link.emplace(link, mine);
      if (!is_new) {
        const int other = result.labels[static_cast<std::size_t>(known->second)];
        std::replace(result.labels.begin(), result.labels.end(), other, result.labels.back());
      }
    }
  }
  return result;
}

// The label of the cell that has this facet, or -1. The facet looks out of its plus side.
template <int Dim>
int FaultEdges<Dim>::labelBeside(Labels const& labels, Facet const& facet, bool plus_side) const
{
  const auto side = plus_side ? sides_.plusSide(facet) : sides_.minusSide(facet);
  for (std::size_t i = 0; i < labels.cells.size(); ++i) {
    auto const& cell = part_.cells[labels.cells[i]];
    std::array<int, Dim + 1> simplex{};
    std::copy(side.begin(), side.end(), simplex.begin());
    int num_common = 0;
    for (int vertex : cell) {
      num_common += contains(side, vertex) ? 1 : 0;
      simplex[Dim] = contains(side, vertex) ? simplex[Dim] : vertex;
    }
    const double measure = mesh::signedMeasure(mesh::corners(part_, simplex));
    const bool is_plus = Dim == 2 ? measure > 0.0 : measure < 0.0;
    if (num_common == Dim && is_plus == plus_side) {
      return labels.labels[i];
    }
  }
  return -1;
}

template <int Dim>
void FaultEdges<Dim>::decide(Edge const& edge, std::vector<TipFacet> const& facets)
{
  const auto labels = labelsAround(edge, facets);
  std::set<int> plus, minus;
  std::set<Edge> plus_edges;
  for (auto const& each : facets) {
    plus.insert(labelBeside(labels, each.facet, true));
    minus.insert(labelBeside(labels, each.facet, false));
    plus_edges.insert(sorted(each.plus));
  }
  ASPERITY_ASSERT(plus.count(-1) == 0 && minus.count(-1) == 0);
  if (labels.count() == 1) {
    return; // a fault ends here
  }
  const auto points = mesh::corners(part_, edge);
  ASPERITY_REQUIRE(labels.count() == 2 && plus.size() == 1 && minus.size() == 1 && plus != minus &&
                     plus_edges.size() == 1,
                   where_ << ": fault '" << *facets.front().fault
                          << "' meets itself or another one between two tips, at "
                          << mesh::text(mesh::centroid(points))
                          << ", where a new vertex would need three copies. Refine the mesh "
                             "there before it is split, with a smaller cell size.");
  auto& cut = cuts_[edge];
  cut.plus = *plus_edges.begin();
  for (std::size_t i = 0; i < labels.cells.size(); ++i) {
    if (labels.labels[i] == *plus.begin()) {
      cut.plus_cells.push_back(labels.cells[i]);
    }
  }
}

template <int Dim>
Edge FaultEdges<Dim>::edgeOfFacet(Edge const& edge) const
{
  Edge above = edge, below = edge;
  for (int i = 0; i < 2; ++i) {
    if (auto const* pair = sides_.find(edge[i])) {
      above[i] = pair->is_tip ? pair->minus : pair->plus;
      below[i] = pair->minus;
    }
  }
  return above == below ? edge : above;
}

template class FaultEdges<2>;
template class FaultEdges<3>;
} // namespace asperity::refinement::detail
