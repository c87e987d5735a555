#include "mesh/faults/detail/VertexSplit.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"

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

template <int Dim>
class Decision
{
public:
  using Sets = typename Star<Dim>::Sets;

  Decision(Star<Dim> const& star, FaultVertex<Dim> const& vertex,
           std::vector<FaultFacet<Dim>> const& facets, std::vector<std::string> const& names,
           std::string const& where)
      : star_(star)
      , vertex_(vertex)
      , facets_(facets)
      , names_(names)
      , where_(where)
  {
    for (int facet : vertex.facets) {
      faults_.insert(faultOf(facet));
    }
  }

  VertexSplit run() const
  {
    const auto sets = star_.cut([](int) { return true; });
    if (sets.count == 1) {
      requireTipInside();
      return {};
    }
    if (sets.count > 3) {
      refuseCrossing(sets.count);
    }
    return sets.count == 2 ? splitInTwo(sets) : splitAtBranch();
  }

private:
  int faultOf(int facet) const { return facets_[static_cast<std::size_t>(facet)].fault; }

  // A fault may end on the surface only where its trace on the surface ends.
  void requireTipInside() const
  {
    ASPERITY_REQUIRE(!vertex_.is_on_surface || vertex_.is_on_trace,
                     where_ << ": a tip of " << list(faults_, names_)
                            << " lies on the boundary of the body, at " << text(vertex_.place)
                            << ", but no edge of the fault does. Let the fault reach the boundary "
                               "along an edge, or end inside the body.");
  }

  [[noreturn]] void refuseCrossing(int num_sets) const
  {
    throw InputError(
      where_ + ": " + list(faults_, names_) +
      (faults_.size() > 1      ? " cross"
       : vertex_.is_on_surface ? " crosses itself, or touches the boundary of the body and goes on,"
                               : " crosses itself") +
      " at " + text(vertex_.place) + ": the cells there are in " + std::to_string(num_sets) +
      " parts, and more than two copies of a node are supported only where a fault with one name "
      "ends inside the body at another fault. Let one fault, with a name of its own, end at the "
      "other or before it.");
  }

  // Each of three faults ends here, and any two of them could be the one that goes on.
  [[noreturn]] void refuseMeeting() const
  {
    throw InputError(
      where_ + ": " + list(faults_, names_) + " meet at " + text(vertex_.place) +
      ", where each of them ends. One fault has to go on there, and another one to end at it as a "
      "branch, without slip at this node. Give the two that are to be one fault the same name: one "
      "physical group, one condition in Mesh / Faults, or one name by 'asperity-mesh convert "
      "--names 3=main,4=main' for groups 3 and 4. Or let one of the three end before it reaches "
      "the "
      "others.");
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

  // Three sets: a branch divides the cells on one side of another fault.
  VertexSplit splitAtBranch() const
  {
    std::set<int> branches;
    for (int fault : faults_) {
      const auto others = star_.cut([&](int facet) { return faultOf(facet) != fault; });
      const auto alone = star_.cut([&](int facet) { return faultOf(facet) == fault; });
      if (others.count == 2 && alone.count == 1) {
        branches.insert(fault);
      }
    }
    if (branches.size() == 3) {
      refuseMeeting();
    }
    if (branches.size() != 1) {
      refuseCrossing(3);
    }
    std::set<int> main = faults_;
    main.erase(*branches.begin());
    return splitAlong(main, star_.cut([&](int facet) { return main.count(faultOf(facet)) > 0; }));
  }

  // Every facet of the main fault is between the two sets, and every branch within one of them.
  VertexSplit splitAlong(std::set<int> const& main, Sets const& sets) const
  {
    VertexSplit split;
    split.is_cut = true;
    const int plus = plusSet(main, sets);
    for (std::size_t c = 0; c < star_.cells().size(); ++c) {
      if (sets.set_of_cell[c] == plus) {
        split.plus_cells.push_back(star_.cells()[c]);
      }
    }
    for (int fault : faults_) {
      if (main.count(fault) == 0) {
        split.branches.push_back({fault, setOfBranch(fault, sets) == plus});
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
                         where_ << ": " << list(main, names_) << " cannot be oriented at "
                                << text(vertex_.place)
                                << ": its plus side changes there. Give parts that only touch "
                                   "each other different names, and separate them.");
        plus = there;
      }
    }
    return plus;
  }

  int setOfBranch(int fault, Sets const& sets) const
  {
    int there = -1;
    for (int facet : vertex_.facets) {
      if (faultOf(facet) == fault) {
        const int set = setOf(sets, facets_[static_cast<std::size_t>(facet)].cells[0]);
        if (separates(sets, facet) || (there >= 0 && there != set)) {
          refuseCrossing(sets.count);
        }
        there = set;
      }
    }
    return there;
  }

  Star<Dim> const& star_;
  FaultVertex<Dim> const& vertex_;
  std::vector<FaultFacet<Dim>> const& facets_;
  std::vector<std::string> const& names_;
  std::string const& where_;
  std::set<int> faults_; // at the vertex
};
} // namespace

template <int Dim>
VertexSplit splitVertex(Star<Dim> const& star, FaultVertex<Dim> const& vertex,
                        std::vector<FaultFacet<Dim>> const& facets,
                        std::vector<std::string> const& names, std::string const& where)
{
  return Decision<Dim>(star, vertex, facets, names, where).run();
}

template VertexSplit splitVertex(Star<2> const&, FaultVertex<2> const&,
                                 std::vector<FaultFacet<2>> const&, std::vector<std::string> const&,
                                 std::string const&);
template VertexSplit splitVertex(Star<3> const&, FaultVertex<3> const&,
                                 std::vector<FaultFacet<3>> const&, std::vector<std::string> const&,
                                 std::string const&);
} // namespace asperity::mesh::detail
