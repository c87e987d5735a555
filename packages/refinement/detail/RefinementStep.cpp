#include "refinement/detail/RefinementStep.hpp"

#include "base/parallel/Agreement.hpp"
#include "refinement/detail/CutCells.hpp"
#include "refinement/detail/RedRule.hpp"
#include "refinement/detail/RefinedPairs.hpp"

#include <memory>
#include <unordered_map>

namespace asperity::refinement::detail
{
namespace
{
template <int Dim>
class Step
{
public:
  using Cell = typename Mesh<Dim>::Cell;
  using Facet = typename Mesh<Dim>::Facet;

  Step(OwnedPart<Dim> const& coarse, FaultEdges<Dim> const& faults,
       Communicator const& communicator)
      : coarse_(coarse.mesh)
      , faults_(faults)
      , communicator_(communicator)
      , edges_(coarse_, faults.edgesOfTips())
      , points_(coarse, edges_, communicator)
      , cut_cells_(coarse, faults, points_, communicator)
      , needed_(static_cast<std::size_t>(points_.size()), 0)
  {
  }

  OwnedPart<Dim> run()
  {
    for (int point = 0; point < points_.size(); ++point) {
      needed_[point] = isOwned(point);
    }
    divideCells();
    pairs_ = pairsOf(needed_, coarse_, faults_, points_, communicator_);
    numberVertices();
    renumber(fine_.mesh.cells);
    addPairs();
    for (auto const& [name, facets] : coarse_.boundaries) {
      if (std::binary_search(coarse_.faults.begin(), coarse_.faults.end(), name)) {
        divideFacetsOfFault(name, facets);
      } else {
        divideFacets(name, facets);
      }
    }
    fine_.mesh.num_global_vertices = points_.numGlobal();
    fine_.mesh.period = coarse_.period;
    fine_.mesh.region_names = coarse_.region_names;
    fine_.mesh.faults = coarse_.faults;
    return std::move(fine_);
  }

private:
  bool isOwned(int point) const { return points_.owner(point) == communicator_.getRank(); }

  template <std::size_t N>
  bool isOwned(std::array<int, N> const& simplex) const
  {
    return std::any_of(simplex.begin(), simplex.end(), [this](int v) { return isOwned(v); });
  }

  // The children that touch an owned vertex, by points.
  void divideCells()
  {
    auto& cells = fine_.mesh.cells;
    cells.reserve(coarse_.cells.size() << Dim); // too much for ghosts: memory that is never touched
    fine_.mesh.cell_regions.reserve(coarse_.cells.size() << Dim);
    constexpr auto num_edges = std::size(RedRule<Dim>::edges);
    std::array<int, Dim + 1 + num_edges> points;
    for (std::size_t c = 0; c < coarse_.cells.size(); ++c) {
      auto const& cell = coarse_.cells[c];
      std::copy(cell.begin(), cell.end(), points.begin());
      for (std::size_t e = 0; e < num_edges; ++e) {
        auto const& [i, j] = RedRule<Dim>::edges[e];
        points[Dim + 1 + e] = cut_cells_.midpoint(cell, cell[i], cell[j]);
      }
      for (auto const& child : RedRule<Dim>::children) {
        const auto fine = childOf<Cell>(points, child);
        if (isOwned(fine)) {
          cells.push_back(fine);
          fine_.mesh.cell_regions.push_back(coarse_.cell_regions[c]);
          for (int point : fine) {
            needed_[point] = 1;
          }
        }
      }
    }
  }

  template <class Simplex, class Points, class Child>
  static Simplex childOf(Points const& points, Child const& child)
  {
    Simplex simplex;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      simplex[i] = points[child[i]];
    }
    return simplex;
  }

  // Owned vertices, then ghosts, each by their global ids. Two points may have one id, where
  // another rank sent what this rank has, too.
  void numberVertices()
  {
    using Entry = std::pair<GlobalOrdinal, int>;
    std::vector<Entry> owned, ghosts;
    const auto num_needed =
      static_cast<std::size_t>(std::count(needed_.begin(), needed_.end(), char(1)));
    owned.reserve(num_needed);
    fine_.mesh.global_ids.reserve(num_needed);
    fine_.mesh.vertices.reserve(num_needed);
    fine_.owners.reserve(num_needed);
    for (int point = 0; point < points_.size(); ++point) {
      if (needed_[point]) {
        (isOwned(point) ? owned : ghosts).push_back({points_.id(point), point});
      }
    }
    number_.assign(static_cast<std::size_t>(points_.size()), -1);
    for (auto* entries : {&owned, &ghosts}) {
      std::sort(entries->begin(), entries->end());
      for (auto const& [id, point] : *entries) {
        auto& ids = fine_.mesh.global_ids;
        const bool is_known = entries->front().first != id && ids.back() == id;
        if (!is_known) {
          ids.push_back(id);
          fine_.mesh.vertices.push_back(points_.coordinates(point));
          fine_.owners.push_back(points_.owner(point));
        }
        number_[point] = static_cast<int>(ids.size()) - 1;
      }
      if (entries == &owned) {
        fine_.mesh.num_owned = static_cast<int>(fine_.mesh.global_ids.size());
      }
    }
  }

  template <std::size_t N>
  void renumber(std::vector<std::array<int, N>>& simplices) const
  {
    for (auto& simplex : simplices) {
      for (int& vertex : simplex) {
        vertex = number_[vertex];
      }
    }
  }

  // The local number of a point of a facet, perhaps that of another point with the same id.
  int numberOf(int point) const
  {
    const int number = number_[static_cast<std::size_t>(point)];
    return number >= 0 ? number : localVertex(fine_.mesh, points_.id(point));
  }

  static constexpr auto num_edges_of_facet = std::size(FacetRule<Dim>::edges);
  using PointsOfFacet = std::array<int, Dim + num_edges_of_facet>; // corners, then midpoints

  void divideFacets(std::string const& name, std::vector<Facet> const& facets)
  {
    PointsOfFacet points;
    for (auto const& facet : facets) {
      std::copy(facet.begin(), facet.end(), points.begin());
      for (std::size_t e = 0; e < num_edges_of_facet; ++e) {
        auto const& [i, j] = FacetRule<Dim>::edges[e];
        points[Dim + e] = cut_cells_.midpoint(facet, facet[i], facet[j]);
      }
      addChildren(
        points, [this, &points](int k) { return numberOf(points[k]); },
        fine_.mesh.boundaries[name]);
    }
    fine_.mesh.boundaries[name]; // also without facets
  }

  void divideFacetsOfFault(std::string const& name, std::vector<Facet> const& facets)
  {
    PointsOfFacet points, below; // on the plus side, on the minus side
    for (auto const& facet : facets) {
      std::copy(facet.begin(), facet.end(), points.begin());
      for (std::size_t e = 0; e < num_edges_of_facet; ++e) {
        auto const& [i, j] = FacetRule<Dim>::edges[e];
        const auto [plus, minus] = faults_.copiesOfEdge(facet, i, j);
        points[Dim + e] = points_.midpoint(plus[0], plus[1]);
        below[Dim + e] = points_.midpoint(minus[0], minus[1]);
      }
      const auto vertex_of = [&](int k) {
        return k < Dim ? numberOf(points[k]) : nodeOf(numberOf(points[k]), below[k]);
      };
      addChildren(points, vertex_of, fine_.mesh.boundaries[name]);
    }
    fine_.mesh.boundaries[name]; // also without facets
  }

  // The children of a facet that touch an owned vertex; vertex_of(place) is a vertex of the mesh.
  template <class VertexOf>
  void addChildren(PointsOfFacet const& points, VertexOf const& vertex_of,
                   std::vector<Facet>& fine) const
  {
    for (auto const& child : FacetRule<Dim>::children) {
      if (isOwned(childOf<Facet>(points, child))) {
        Facet facet;
        std::transform(std::begin(child), std::end(child), facet.begin(), vertex_of);
        fine.push_back(facet);
      }
    }
  }

  // The vertex of the facets of a fault at the place of a vertex of its plus side. The two differ
  // at crossings, on the plus side of both faults: there the minus side of the fault has the vertex
  // of the other one. They also differ at joints, for the fault that goes on, on the plus side of
  // the branch, if this lies on the plus side of that fault.
  int nodeOf(int vertex, int point_below) const
  {
    const auto joint = joints_.find(vertex);
    if (joint != joints_.end()) {
      const int below = numberOf(point_below);
      const bool is_of_branch = below == joint->second.minus || below == vertex;
      return is_of_branch ? vertex : joint->second.main;
    }
    const auto crossing = crossings_.find(vertex);
    if (crossing == crossings_.end()) {
      return vertex;
    }
    auto const& plus = crossing->second.plus;
    return plus[plus[0] == numberOf(point_below) ? 1 : 0];
  }

  void addPairs()
  {
    auto& splits = fine_.mesh.splits;
    for (auto const& pair : pairs_) {
      splits.push_back(
        mesh::splitVertex(numberOf(pair.plus), numberOf(pair.minus), mesh::kindOf(pair)));
    }
    std::sort(splits.begin(), splits.end(),
              [](auto const& a, auto const& b) { return a.plus < b.plus; });
    for (auto const& crossing : mesh::crossingsOf(splits)) {
      crossings_.emplace(crossing.both, crossing);
    }
    for (auto const& joint : mesh::jointsOf(splits)) {
      joints_.emplace(joint.plus, joint);
    }
  }

  Mesh<Dim> const& coarse_;
  FaultEdges<Dim> const& faults_;
  Communicator const& communicator_;
  PartEdges<Dim> edges_;
  Points<Dim> points_;
  CutCells<Dim> cut_cells_;
  std::vector<char> needed_;       // (num_points) 1 if a vertex of the refined part
  std::vector<int> number_;        // (num_points) its local number, or -1
  std::vector<SplitVertex> pairs_; // by points
  std::unordered_map<int, mesh::Crossing> crossings_; // of the refined part, by `both`
  std::unordered_map<int, mesh::Joint> joints_;       // of the refined part, by plus
  OwnedPart<Dim> fine_;
};
} // namespace

template <int Dim>
OwnedPart<Dim> refineOnce(OwnedPart<Dim> const& coarse, Communicator const& communicator,
                          std::string const& where)
{
  std::unique_ptr<const FaultEdges<Dim>> faults;
  onEveryRank(communicator,
              [&] { faults = std::make_unique<const FaultEdges<Dim>>(coarse.mesh, where); });
  return Step<Dim>(coarse, *faults, communicator).run();
}

template OwnedPart<2> refineOnce(OwnedPart<2> const&, Communicator const&, std::string const&);
template OwnedPart<3> refineOnce(OwnedPart<3> const&, Communicator const&, std::string const&);
} // namespace asperity::refinement::detail
