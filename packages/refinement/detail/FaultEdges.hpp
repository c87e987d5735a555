#pragma once

#include "mesh/Mesh.hpp"
#include "mesh/SplitVertices.hpp"
#include "mesh/faults/detail/Star.hpp"
#include "refinement/detail/PartEdges.hpp"

#include <map>
#include <set>

namespace asperity::refinement::detail
{
// Whether a cell has all vertices of another cell or a facet.
template <std::size_t N, std::size_t M>
bool hasVertices(std::array<int, N> const& cell, std::array<int, M> const& simplex)
{
  return std::all_of(simplex.begin(), simplex.end(), [&](int vertex) {
    return std::find(cell.begin(), cell.end(), vertex) != cell.end();
  });
}

// A pair of new vertices on a fault: the midpoints of the edges `plus` and `minus`, which are
// copies of one edge of a facet. Of the four copies of an edge along which two faults cross, three
// are the plus of a pair with the fourth one. Of the three of an edge along which a branch ends,
// two are the pair of the fault that goes on, and the third one is the plus of a joint
// (mesh::Joint).
struct MidpointPair
{
  Edge plus, minus; // local vertices, ascending
  bool is_tip = false;
  bool is_joint = false;
};

// An edge whose ends are tips, but whose middle slips: it leads from tip to tip through the inside
// of a fault, as at the corner of one. Cells on the plus side get the midpoint of another edge.
struct CutEdge
{
  Edge plus;
  std::vector<int> plus_cells;
};

// The copies of midpoints that faults need when a part is refined. The midpoint of an edge has two
// copies if the cells around it fall into two sets when the facets of the faults are cut, as in
// splitFaults, and three where they fall into three at a joint.
template <int Dim>
class FaultEdges
{
public:
  using Facet = typename Mesh<Dim>::Facet;

  // InputError, which starts with `where`, if a midpoint needs copies that the edges of cells do
  // not tell apart. Not collective.
  FaultEdges(Mesh<Dim> const& part, std::string const& where);

  // Edges of facets between two tips, by their plus vertices: no cell has them.
  std::vector<Edge> const& edgesOfTips() const { return edges_of_tips_; }

  // The cells around the edges that may be cut: all of them if an end of the edge is owned.
  std::map<Edge, std::vector<int>> const& rings() const { return rings_; }

  // nullptr if the edge is not cut. This rank must own an end of it.
  CutEdge const* find(Edge const& edge) const
  {
    const auto found = cuts_.find(edge);
    return found == cuts_.end() ? nullptr : &found->second;
  }

  // The pairs of the edges with an owned end; each once.
  std::vector<MidpointPair> const& pairs() const { return pairs_; }

  // The copies, on both sides of a facet of a fault, of its edge between the corners i and j. At
  // tips both are the edge of the facet itself, which no cell has.
  std::array<Edge, 2> copiesOfEdge(Facet const& facet, int i, int j) const;

  bool isOfPair(int vertex) const { return has_pair_[static_cast<std::size_t>(vertex)]; }

private:
  struct TipFacet
  {
    std::string const* fault;
    Facet facet;
    Edge plus;
  };
  using Star = mesh::detail::Star<Dim>;

  // The steps of the constructor, in this order.
  void markPairs();
  void collectEdges();
  void addFacet(std::string const& fault, Facet const& facet);
  void findRings();
  void decideEdgesOfTips();
  void requireNoCrossing() const;
  void sortPairs();
  void findJoints();
  Edge withoutJoint(Edge const& edge) const;
  bool mayHaveJoint(int first, int second) const;

  void decideCut(Edge const& edge, std::vector<TipFacet> const& facets, bool is_of_other_fault);
  [[noreturn]] void refuseCopies(Edge const& edge, std::string const& fault) const;
  int cellSetOn(Star const& star, typename Star::Sets const& sets, Facet const& facet,
                bool plus_side) const;
  bool isOwned(Edge const& edge) const
  {
    return edge[0] < part_.num_owned || edge[1] < part_.num_owned;
  }

  Mesh<Dim> const& part_;
  std::string const& where_;
  mesh::FaultSides<Dim> sides_;
  std::vector<bool> has_pair_, is_minus_of_tip_; // (num_local)
  std::vector<Edge> edges_of_tips_;
  std::map<Edge, std::vector<TipFacet>> tip_facets_; // by the edge that the cells have
  std::map<Edge, std::vector<int>> rings_;
  std::map<Edge, CutEdge> cuts_;
  std::vector<MidpointPair> pairs_;
  std::map<Edge, MidpointPair> joints_;           // by their plus
  std::map<Edge, std::set<std::string>> open_to_; // the faults that have this copy of an edge
};
} // namespace asperity::refinement::detail
