#include "mesh/faults/detail/VertexSplit.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"

#include <iterator>
#include <map>
#include <set>

namespace asperity::mesh::detail
{
namespace
{
// "fault 'a'", "faults 'a', 'b' and 'c'"
std::string list(std::set<int> const& faults, std::vector<std::string> const& names)
{
  std::string text = faults.size() == 1 ? "fault " : "faults ";
  std::size_t left = faults.size();
  for (int fault : faults) {
    text += "'" + names[static_cast<std::size_t>(fault)] + "'";
    --left;
    text += left > 1 ? ", " : left == 1 ? " and " : "";
  }
  return text;
}

// Names that go on into each other at the vertex are one fault, which has the number of its first
// name.
template <int Dim>
class Decision
{
public:
  using Sets = typename Star<Dim>::Sets;

  Decision(Star<Dim> const& star, FaultVertex<Dim> const& vertex,
           std::vector<FaultFacet<Dim>> const& facets, std::vector<std::string> const& names,
           bool has_joints, std::string const& where)
      : star_(star)
      , vertex_(vertex)
      , facets_(facets)
      , names_(names)
      , has_joints_(has_joints)
      , where_(where)
  {
    for (int facet : vertex.facets) {
      fault_of_name_.emplace(nameOf(facet), nameOf(facet));
    }
    for (auto const& [a, b] : vertex.joined) {
      const auto [first, second] = std::minmax({faultOf(a), faultOf(b)});
      for (auto& [name, fault] : fault_of_name_) {
        fault = fault == second ? first : fault;
      }
    }
    for (auto const& [name, fault] : fault_of_name_) {
      faults_.insert(fault);
    }
  }

  VertexSplit run() const
  {
    const auto sets = star_.cut([](int) { return true; });
    if (sets.count == 1) {
      requireTipInside();
      return {};
    }
    if (sets.count == 2) {
      return splitInTwo(sets);
    }
    std::vector<int> going_on;
    for (int fault : faults_) {
      if (cutAlong(fault).count > 1) {
        going_on.push_back(fault);
      }
    }
    if (going_on.size() == 1) {
      return splitAlong({going_on[0]}, cutAlong(going_on[0]));
    }
    // In the plane faults that meet on the surface of the body end there.
    if (going_on.size() == 2 && sets.count == 4 && (Dim == 3 || !vertex_.is_on_surface)) {
      return splitAtCrossing({going_on[0], going_on[1]});
    }
    if (going_on.empty() && sets.count == 3 && faults_.size() == 3) {
      refuseMeeting();
    }
    refuseCrossing(sets.count);
  }

private:
  int nameOf(int facet) const { return facets_[static_cast<std::size_t>(facet)].fault; }
  int faultOf(int facet) const { return fault_of_name_.at(nameOf(facet)); }

  // The sets that the cells form when this fault alone is cut.
  Sets cutAlong(int fault) const
  {
    return star_.cut([&](int facet) { return faultOf(facet) == fault; });
  }

  std::vector<int> facetsOf(int fault) const
  {
    std::vector<int> its;
    std::copy_if(vertex_.facets.begin(), vertex_.facets.end(), std::back_inserter(its),
                 [&](int facet) { return faultOf(facet) == fault; });
    return its;
  }

  std::string namesOf(std::set<int> const& faults) const
  {
    std::set<int> its;
    for (auto const& [name, fault] : fault_of_name_) {
      if (faults.count(fault) > 0) {
        its.insert(name);
      }
    }
    return list(its, names_);
  }

  // A fault may end on the surface only where its trace on the surface ends.
  void requireTipInside() const
  {
    ASPERITY_REQUIRE(!vertex_.is_on_surface || vertex_.is_on_trace,
                     where_ << ": a tip of " << namesOf(faults_)
                            << " lies on the boundary of the body, at " << text(vertex_.place)
                            << ", but no edge of the fault does. Let the fault reach the boundary "
                               "along an edge, or end inside the body.");
  }

  [[noreturn]] void refuseCrossing(int num_sets) const
  {
    throw InputError(
      where_ + ": " + namesOf(faults_) +
      (fault_of_name_.size() > 1 ? " cross"
       : vertex_.is_on_surface ? " crosses itself, or touches the boundary of the body and goes on,"
                               : " crosses itself") +
      " at " + text(vertex_.place) + ": the cells there are in " + std::to_string(num_sets) +
      " parts, and more than two copies of a node are supported only where faults end inside the "
      "body at another one, or two faults cross inside the body and no other one is there. Let one "
      "fault, with a name of its own, end at the other or before it.");
  }

  // Each of three faults ends here, and any two of them could be the one that goes on.
  [[noreturn]] void refuseMeeting() const
  {
    throw InputError(
      where_ + ": " + namesOf(faults_) + " meet at " + text(vertex_.place) +
      ", where each of them ends and no two of them are clearly the straightest pair. One fault "
      "has to go on there, and another one to end at it as a branch. Give the two that are to be "
      "one fault the same name: one physical group, one condition in Mesh / Faults, or one name by "
      "'asperity-mesh convert --names 3=main,4=main' for groups 3 and 4. Or let one of the three "
      "end before it reaches the others.");
  }

  int setOf(Sets const& sets, int cell) const
  {
    auto const& cells = star_.cells();
    const auto place = std::find(cells.begin(), cells.end(), cell) - cells.begin();
    return sets.set_of_cell[static_cast<std::size_t>(place)];
  }

  bool separates(Sets const& sets, int facet) const
  {
    auto const& cells = facets_[static_cast<std::size_t>(facet)].cells;
    return setOf(sets, cells[0]) != setOf(sets, cells[1]);
  }

  VertexSplit splitInTwo(Sets const& sets) const
  {
    std::set<int> main;
    for (int facet : vertex_.facets) {
      if (separates(sets, facet)) {
        main.insert(faultOf(facet));
      }
    }
    return splitAlong(main, sets);
  }

  // Four sets: each of two faults that go on divides all cells in two.
  VertexSplit splitAtCrossing(std::array<int, 2> const& faults) const
  {
    VertexSplit::Crossing crossing;
    crossing.facets = {facetsOf(faults[0]), facetsOf(faults[1])};
    const auto plusCellsOf = [&](int fault) {
      const auto sets = cutAlong(fault);
      return cellsIn(sets, plusSet({fault}, sets));
    };
    const auto plus_of_first = plusCellsOf(faults[0]);
    const auto plus_of_second = plusCellsOf(faults[1]);
    const auto has = [](std::vector<int> const& cells, int cell) {
      return std::find(cells.begin(), cells.end(), cell) != cells.end();
    };
    bool touches_neither = false;
    for (int cell : star_.cells()) {
      const bool first = has(plus_of_first, cell), second = has(plus_of_second, cell);
      if (first || second) {
        (first && second ? crossing.both_cells : crossing.plus_cells[first ? 0 : 1])
          .push_back(cell);
      }
      touches_neither = touches_neither || (!first && !second);
    }
    // Faults that only touch each other leave one of the four without a cell.
    if (!touches_neither || crossing.both_cells.empty() || crossing.plus_cells[0].empty() ||
        crossing.plus_cells[1].empty()) {
      refuseTouching();
    }
    VertexSplit split;
    split.is_cut = true;
    split.crossing = std::move(crossing);
    return split;
  }

  [[noreturn]] void refuseTouching() const
  {
    throw InputError(where_ + ": " + namesOf(faults_) + " touch each other at " +
                     text(vertex_.place) +
                     " and go on without crossing. Separate them by a cell or two, or give their "
                     "parts names so that one goes on and the others end at it.");
  }

  std::vector<int> cellsIn(Sets const& sets, int set) const
  {
    std::vector<int> cells;
    for (std::size_t c = 0; c < star_.cells().size(); ++c) {
      if (sets.set_of_cell[c] == set) {
        cells.push_back(star_.cells()[c]);
      }
    }
    return cells;
  }

  // Every facet of the main fault is between the two sets, and every branch within one of them.
  VertexSplit splitAlong(std::set<int> const& main, Sets const& sets) const
  {
    if (sets.count != 2) {
      refuseCrossing(sets.count);
    }
    VertexSplit split;
    split.is_cut = true;
    const int plus = plusSet(main, sets);
    split.plus_cells = cellsIn(sets, plus);
    for (int fault : faults_) {
      if (main.count(fault) == 0) {
        addBranches(fault, sets, plus, split);
      }
    }
    for (auto& branch : split.branches) {
      const auto others =
        std::count_if(split.branches.begin(), split.branches.end(), [&](auto const& other) {
          return other.is_on_plus_side == branch.is_on_plus_side;
        });
      if (has_joints_ && others == 1) {
        branch.plus_cells = plusCellsAtJoint(branch, main);
      }
    }
    return split;
  }

  int plusSet(std::set<int> const& main, Sets const& sets) const
  {
    int plus = -1;
    for (int facet : vertex_.facets) {
      if (main.count(faultOf(facet)) > 0) {
        const int there = setOf(sets, facets_[static_cast<std::size_t>(facet)].cells[0]);
        if (!separates(sets, facet)) {
          refuseCrossing(sets.count);
        }
        ASPERITY_REQUIRE(plus < 0 || plus == there,
                         where_ << ": " << namesOf(main) << " cannot be oriented at "
                                << text(vertex_.place)
                                << ": its plus side changes there. Give parts that only touch "
                                   "each other different names, and separate them.");
        plus = there;
      }
    }
    return plus;
  }

  // A branch on each side that has facets: both in space, where the line ends along which faults
  // cross.
  void addBranches(int fault, Sets const& sets, int plus, VertexSplit& split) const
  {
    VertexSplit::Branch below{{}, false}, above{{}, true};
    for (int facet : facetsOf(fault)) {
      if (separates(sets, facet)) {
        refuseCrossing(sets.count);
      }
      const int there = setOf(sets, facets_[static_cast<std::size_t>(facet)].cells[0]);
      (there == plus ? above : below).facets.push_back(facet);
    }
    for (auto const& branch : {below, above}) {
      if (!branch.facets.empty()) {
        split.branches.push_back(branch);
      }
    }
  }

  // The cells on the plus side of a branch if it alone divides those on its side of the main fault
  // in two, else none.
  std::vector<int> plusCellsAtJoint(VertexSplit::Branch const& branch,
                                    std::set<int> const& main) const
  {
    if (Dim == 3 && !meetAlongALine(branch, main)) {
      return {};
    }
    const auto sets = star_.cut([](int) { return true; });
    std::set<int> plus, minus;
    for (int facet : branch.facets) {
      auto const& cells = facets_[static_cast<std::size_t>(facet)].cells;
      plus.insert(setOf(sets, cells[0]));
      minus.insert(setOf(sets, cells[1]));
    }
    return plus.size() == 1 && minus.size() == 1 && plus != minus ? cellsIn(sets, *plus.begin())
                                                                  : std::vector<int>{};
  }

  // Whether edges of both go on from the vertex, in space, to two sides or to the surface.
  bool meetAlongALine(VertexSplit::Branch const& branch, std::set<int> const& main) const
  {
    std::set<int> of_branch, of_main, of_both; // ends of edges that begin at the vertex
    for (int facet : branch.facets) {
      auto const& key = facets_[static_cast<std::size_t>(facet)].key;
      of_branch.insert(key.begin(), key.end());
    }
    for (int facet : vertex_.facets) {
      if (main.count(faultOf(facet)) > 0) {
        auto const& key = facets_[static_cast<std::size_t>(facet)].key;
        of_main.insert(key.begin(), key.end());
      }
    }
    std::set_intersection(of_branch.begin(), of_branch.end(), of_main.begin(), of_main.end(),
                          std::inserter(of_both, of_both.end()));
    of_both.erase(vertex_.number);
    return of_both.size() == 2 || (of_both.size() == 1 && vertex_.is_on_surface);
  }

  Star<Dim> const& star_;
  FaultVertex<Dim> const& vertex_;
  std::vector<FaultFacet<Dim>> const& facets_;
  std::vector<std::string> const& names_;
  bool has_joints_;
  std::string const& where_;
  std::map<int, int> fault_of_name_; // at the vertex
  std::set<int> faults_;
};
} // namespace

template <int Dim>
VertexSplit splitVertex(Star<Dim> const& star, FaultVertex<Dim> const& vertex,
                        std::vector<FaultFacet<Dim>> const& facets,
                        std::vector<std::string> const& names, bool has_joints,
                        std::string const& where)
{
  return Decision<Dim>(star, vertex, facets, names, has_joints, where).run();
}

template VertexSplit splitVertex(Star<2> const&, FaultVertex<2> const&,
                                 std::vector<FaultFacet<2>> const&, std::vector<std::string> const&,
                                 bool, std::string const&);
template VertexSplit splitVertex(Star<3> const&, FaultVertex<3> const&,
                                 std::vector<FaultFacet<3>> const&, std::vector<std::string> const&,
                                 bool, std::string const&);
} // namespace asperity::mesh::detail
