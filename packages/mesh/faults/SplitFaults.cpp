#include "mesh/faults/SplitFaults.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/InnerBoundaries.hpp"
#include "mesh/faults/detail/VertexSplit.hpp"

#include <algorithm>
#include <set>

namespace asperity::mesh
{
namespace
{
template <int Dim>
class Splitter
{
public:
  using Facet = typename GlobalMesh<Dim>::Facet;

  Splitter(GlobalMesh<Dim> const& mesh, std::string const& where, BranchEnd branch_end)
      : mesh_(mesh)
      , where_(where)
      , branch_end_(branch_end)
      , table_(mesh.cells)
      , names_(detail::innerBoundaries(mesh, table_, where))
  {
    auto oriented = detail::orientedFaultFacets(mesh, table_, names_, where);
    facets_ = std::move(oriented.facets);
    joined_ = std::move(oriented.joined);
  }

  bool hasFaults() const { return !names_.empty(); }

  GlobalMesh<Dim> run()
  {
    result_ = mesh_;
    result_.faults = names_;
    findVertices();
    for (std::size_t v = 0; v < fault_vertices_.size(); ++v) {
      split(static_cast<int>(v));
    }
    requireNodesThatSlip();
    moveFaultFacets();
    moveOuterFacets();
    return std::move(result_);
  }

private:
  // Finds the vertices of faults, ascending, with the fault facets and the cells at each.
  void findVertices()
  {
    number_.assign(mesh_.vertices.size(), -1);
    std::set<int> vertices;
    for (auto const& facet : facets_) {
      vertices.insert(facet.key.begin(), facet.key.end());
    }
    fault_vertices_.assign(vertices.begin(), vertices.end());
    for (std::size_t v = 0; v < fault_vertices_.size(); ++v) {
      number_[fault_vertices_[v]] = static_cast<int>(v);
    }
    facets_at_.resize(fault_vertices_.size());
    joined_at_.resize(fault_vertices_.size());
    cells_at_.resize(fault_vertices_.size());
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      for (int vertex : facets_[f].key) {
        facets_at_[number_[vertex]].push_back(static_cast<int>(f));
      }
    }
    for (auto const& pair : joined_) {
      auto const& other = facets_[pair[1]].key;
      for (int vertex : facets_[pair[0]].key) {
        if (std::find(other.begin(), other.end(), vertex) != other.end()) {
          joined_at_[number_[vertex]].push_back(pair);
        }
      }
    }
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      for (int vertex : mesh_.cells[c]) {
        if (number_[vertex] >= 0) {
          cells_at_[number_[vertex]].push_back(static_cast<int>(c));
        }
      }
    }
    findSurface();
  }

  // Finds the vertices of faults, and the edges between two of them, on the surface of the body.
  void findSurface()
  {
    for (auto const* entry : table_.outerEntries()) {
      for (int a : entry->key) {
        if (number_[a] >= 0) {
          on_surface_.insert(a);
          for (int b : entry->key) {
            if (b > a && number_[b] >= 0) {
              edges_on_surface_.insert({a, b});
            }
          }
        }
      }
    }
  }

  bool isEdgeOnSurface(int first, int second) const
  {
    return edges_on_surface_.count({std::min(first, second), std::max(first, second)}) > 0;
  }

  bool isOnTrace(int vertex) const
  {
    for (int facet : facets_at_[number_[vertex]]) {
      auto const& others = facets_[facet].key;
      if (std::any_of(others.begin(), others.end(),
                      [&](int other) { return isEdgeOnSurface(vertex, other); })) {
        return true;
      }
    }
    return false;
  }

  int faultFacet(Facet const& key) const
  {
    const auto found =
      std::lower_bound(facets_.begin(), facets_.end(), key,
                       [](auto const& facet, Facet const& wanted) { return facet.key < wanted; });
    return found != facets_.end() && found->key == key ? static_cast<int>(found - facets_.begin())
                                                       : -1;
  }

  void split(int number)
  {
    const int vertex = fault_vertices_[number];
    const detail::Star<Dim> star(mesh_.cells, cells_at_[number], std::array<int, 1>{vertex},
                                 [this](Facet const& key) { return faultFacet(key); });
    const auto decision = detail::splitVertex<Dim>(
      star,
      {vertex, mesh_.vertices[vertex], facets_at_[number], joined_at_[number],
       on_surface_.count(vertex) > 0, isOnTrace(vertex)},
      facets_, names_, branch_end_ == BranchEnd::joint, where_);
    const int plus = addCopy(vertex, vertex, !decision.is_cut);
    copies_.push_back(plus);
    if (decision.crossing) {
      splitAtCrossing(vertex, plus, *decision.crossing);
      return;
    }
    giveVertex(decision.plus_cells, vertex, plus);
    for (auto const& branch : decision.branches) {
      const int minus = branch.is_on_plus_side ? plus : vertex;
      const bool is_joint = !branch.plus_cells.empty();
      const int copy = addCopy(vertex, minus, !is_joint, is_joint);
      giveOwnCopy(branch.facets, vertex, copy);
      giveVertex(branch.plus_cells, minus, copy);
    }
  }

  // plus_of_first: the copy that the vertex already has. The pairs are in the order of
  // mesh::Crossing.
  void splitAtCrossing(int vertex, int plus_of_first, detail::VertexSplit::Crossing const& crossing)
  {
    const int plus_of_second = addCopy(vertex, vertex, false);
    const int both = addCopy(vertex, vertex, false);
    giveOwnCopy(crossing.facets[1], vertex, plus_of_second);
    giveVertex(crossing.plus_cells[0], vertex, plus_of_first);
    giveVertex(crossing.plus_cells[1], vertex, plus_of_second);
    giveVertex(crossing.both_cells, vertex, both);
  }

  void giveVertex(std::vector<int> const& cells, int vertex, int copy)
  {
    for (int cell : cells) {
      auto& vertices = result_.cells[cell];
      std::replace(vertices.begin(), vertices.end(), vertex, copy);
    }
  }

  void giveOwnCopy(std::vector<int> const& facets, int vertex, int copy)
  {
    for (int facet : facets) {
      own_copies_[{facet, vertex}] = copy;
    }
  }

  int addCopy(int vertex, int minus, bool is_tip, bool is_joint = false)
  {
    const auto plus = static_cast<int>(result_.vertices.size());
    result_.vertices.push_back(mesh_.vertices[vertex]);
    result_.splits.push_back({plus, minus, is_tip, is_joint});
    return plus;
  }

  // The copy of a vertex that a facet of a fault uses.
  int plusOf(std::size_t facet, int vertex) const
  {
    const auto own = own_copies_.find({static_cast<int>(facet), vertex});
    return own == own_copies_.end() ? copies_[number_[vertex]] : own->second;
  }

  void requireNodesThatSlip() const
  {
    const auto first_copy = static_cast<int>(mesh_.vertices.size());
    std::vector<bool> slips(names_.size(), false);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      auto const& facet = facets_[f];
      for (int vertex : facet.key) {
        const int plus = plusOf(f, vertex);
        slips[facet.fault] = slips[facet.fault] || !result_.splits[plus - first_copy].is_tip;
      }
    }
    for (std::size_t n = 0; n < names_.size(); ++n) {
      ASPERITY_REQUIRE(slips[n], where_ << ": fault '" << names_[n]
                                        << "' has no node that could slip; refine the mesh. All "
                                           "its vertices are tips, where it ends inside the "
                                           "body.");
    }
  }

  void moveFaultFacets()
  {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      auto const& facet = facets_[f];
      auto& moved = result_.boundaries[names_[facet.fault]][facet.number];
      moved = facet.outward;
      for (int& vertex : moved) {
        vertex = plusOf(f, vertex);
      }
    }
  }

  // Facets of the surface get the vertices of their cells.
  void moveOuterFacets()
  {
    for (auto& [name, facets] : result_.boundaries) {
      if (std::binary_search(names_.begin(), names_.end(), name)) {
        continue;
      }
      for (auto& facet : facets) {
        const auto cell = static_cast<std::size_t>(table_.find(facet).first->cell);
        auto const& before = mesh_.cells[cell];
        for (int& vertex : facet) {
          const auto corner = std::find(before.begin(), before.end(), vertex) - before.begin();
          vertex = result_.cells[cell][static_cast<std::size_t>(corner)];
        }
      }
    }
  }

  GlobalMesh<Dim> const& mesh_;
  std::string const& where_;
  BranchEnd branch_end_;
  detail::FacetTable<Dim> table_;
  std::vector<std::string> names_;
  std::vector<detail::FaultFacet<Dim>> facets_;        // sorted by key
  std::vector<std::array<int, 2>> joined_;             // of OrientedFacets
  std::vector<int> fault_vertices_;                    // ascending
  std::vector<int> number_;                            // among fault_vertices_, or -1
  std::vector<std::vector<int>> facets_at_, cells_at_; // of the fault's vertex with this number
  std::vector<std::vector<std::array<int, 2>>> joined_at_;
  std::set<int> on_surface_;
  std::set<std::pair<int, int>> edges_on_surface_;
  std::vector<int> copies_; // the plus of the fault's vertex with this number
  // By facet and vertex: the ends of branches, and the plus of the second fault at a crossing.
  std::map<std::pair<int, int>, int> own_copies_;
  GlobalMesh<Dim> result_;
};
} // namespace

template <int Dim>
void splitFaults(GlobalMesh<Dim>& mesh, std::string const& where, BranchEnd branch_end)
{
  Splitter<Dim> splitter(mesh, where, branch_end);
  if (!splitter.hasFaults()) {
    return;
  }
  ASPERITY_ASSERT(mesh.splits.empty());
  ASPERITY_REQUIRE(mesh.period == Point<Dim>{},
                   where << ": a periodic mesh cannot have faults inside the body. Remove the "
                            "period or the faults.");
  mesh = splitter.run();
}

template void splitFaults(GlobalMesh<2>&, std::string const&, BranchEnd);
template void splitFaults(GlobalMesh<3>&, std::string const&, BranchEnd);
} // namespace asperity::mesh
