#include "FaultSamples.hpp"

#include "mesh/generation/PeriodicMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
bool isOnXAxis(Point<2> const& p) { return p[1] == 0.0; }
bool isAtTwo(Point<2> const& p) { return p[0] == 2.0; }
bool isUpwardAtTwo(Point<2> const& p) { return p[0] == 2.0 && p[1] >= 0.0; }
bool isOnDiagonal(Point<2> const& p) { return p[0] - 2.0 == p[1]; }

// Cells of which a vertex is the plus of a pair lie above y = 0, and those of a minus below.
void expectPlusAbove(GlobalMesh<2> const& mesh)
{
  for (auto const& pair : mesh.splits) {
    for (auto const& cell : mesh.cells) {
      const double y = centroid(corners(mesh, cell))[1];
      for (int vertex : cell) {
        EXPECT_TRUE(pair.is_tip || vertex != pair.plus || y > 0.0);
        EXPECT_TRUE(pair.is_tip || vertex != pair.minus || y < 0.0);
      }
    }
  }
}

// The mesh with vertices in the opposite order.
template <int Dim>
GlobalMesh<Dim> renumbered(GlobalMesh<Dim> mesh)
{
  const auto last = static_cast<int>(mesh.vertices.size()) - 1;
  std::reverse(mesh.vertices.begin(), mesh.vertices.end());
  const auto renumber = [last](auto& simplices) {
    for (auto& simplex : simplices) {
      for (int& vertex : simplex) {
        vertex = last - vertex;
      }
    }
  };
  renumber(mesh.cells);
  for (auto& boundary : mesh.boundaries) {
    renumber(boundary.second);
  }
  return mesh;
}

// The cells with a plus vertex that is not a tip.
template <int Dim>
std::set<std::size_t> cellsOnPlusSides(GlobalMesh<Dim> const& mesh)
{
  const FaultSides<Dim> sides(mesh);
  std::set<std::size_t> cells;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (int vertex : mesh.cells[c]) {
      if (sides.find(vertex)) {
        cells.insert(c);
      }
    }
  }
  return cells;
}

template <int Dim>
void expectRefused(GlobalMesh<Dim> mesh, std::vector<std::string> const& pieces)
{
  test::expectRefusal([&] { splitFaults(mesh, "Here"); }, pieces);
  EXPECT_TRUE(mesh.splits.empty());
}
} // namespace

TEST(SplitFaults, LeavesAMeshWithoutFaults)
{
  auto mesh = rectangleMesh({1.0, 1.0, 2, 2, {0.0, 0.0}});
  splitFaults(mesh, "test");
  EXPECT_TRUE(mesh.splits.empty());
  EXPECT_TRUE(mesh.faults.empty());
  EXPECT_EQ(mesh.vertices.size(), 9u);
}

TEST(SplitFaults, CutsTheWholeRectangle)
{
  const auto mesh = goodSplit(faultedRectangle({{"fault", isOnXAxis}}), 0, 5);
  EXPECT_EQ(mesh.faults, std::vector<std::string>{"fault"});
  EXPECT_EQ(mesh.boundaries.at("fault").size(), 4u);
  expectPlusAbove(mesh);
  EXPECT_EQ(upOf(mesh, "fault"), (Point<2>{0.0, 4.0}));
}

TEST(SplitFaults, EndsInTipsInsideTheBody)
{
  const auto mesh = goodSplit(
    faultedRectangle({{"fault", [](auto& p) { return isOnXAxis(p) && p[0] > 0.5 && p[0] < 3.5; }}}),
    2, 1);
  expectPlusAbove(mesh);
  EXPECT_FALSE(pairsAt<2>(mesh, {2.0, 0.0}).at(0).is_tip);
  EXPECT_TRUE(pairsAt<2>(mesh, {1.0, 0.0}).at(0).is_tip);
}

// A vertical fault: plus is the side with larger x.
TEST(SplitFaults, ReachesTheSurface)
{
  const auto mesh = goodSplit(faultedRectangle({{"fault", isUpwardAtTwo}}), 1, 2);
  EXPECT_EQ(upOf(mesh, "fault"), (Point<2>{2.0, 0.0}));
  for (auto const& facet : mesh.boundaries.at("top")) {
    const bool is_right = centroid(corners(mesh, facet))[0] > 2.0;
    for (int vertex : facet) {
      EXPECT_EQ(vertex >= 25, is_right && mesh.vertices[vertex][0] == 2.0);
    }
  }
}

// Plus of a fault that dips is the hanging wall.
TEST(SplitFaults, TakesTheHangingWallForPlus)
{
  const auto mesh = goodSplit(faultedRectangle({{"fault", isOnDiagonal}}), 0, 5);
  EXPECT_EQ(upOf(mesh, "fault"), (Point<2>{-4.0, 4.0}));
}

// Along y = 0 and then up: the second piece goes on where the first one ends, whatever its name;
// alone it would be oriented the other way round.
TEST(SplitFaults, KeepsTheSideAlongABentFault)
{
  const auto flat = [](auto& p) { return isOnXAxis(p) && p[0] <= 2.0; };
  const auto bent = goodSplit(
    faultedRectangle({{"fault", [&](auto& p) { return flat(p) || isUpwardAtTwo(p); }}}), 0, 5);
  EXPECT_EQ(upOf(bent, "fault"), (Point<2>{-2.0, 2.0}));
  const auto named =
    goodSplit(faultedRectangle({{"flat", flat},
                                {"ramp", [](auto& p) { return isUpwardAtTwo(p) && p[1] <= 1.0; }}}),
              1, 3);
  EXPECT_EQ(upOf(named, "flat"), (Point<2>{0.0, 2.0}));
  EXPECT_EQ(upOf(named, "ramp"), (Point<2>{-1.0, 0.0}));
  EXPECT_EQ(pairsAt<2>(named, {2.0, 0.0}).size(), 1u); // both have it
}

TEST(SplitFaults, GivesABranchATip)
{
  for (const double side : {1.0, -1.0}) {
    const auto mesh = goodSplit(
      faultedRectangle(
        {{"main", isOnXAxis}, {"splay", [=](auto& p) { return isAtTwo(p) && side * p[1] >= 0; }}}),
      1, 5 + 2);
    const auto pairs = pairsAt<2>(mesh, {2.0, 0.0});
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_FALSE(pairs[0].is_tip);
    EXPECT_TRUE(pairs[1].is_tip);
    EXPECT_EQ(pairs[1].minus, side > 0.0 ? pairs[0].plus : pairs[0].minus);
    EXPECT_EQ(upOf(mesh, "splay"), (Point<2>{2.0, 0.0}));
    int num_facets = 0;
    for (auto const& [name, facets] : mesh.boundaries) {
      for (auto const& facet : facets) {
        if (std::count(facet.begin(), facet.end(), pairs[1].plus) > 0) {
          EXPECT_EQ(name, "splay");
          ++num_facets;
        }
      }
    }
    EXPECT_EQ(num_facets, 1);
  }
}

TEST(SplitFaults, DoesNotDependOnTheNumbering)
{
  const auto mesh = faultedRectangle(
    {{"main", isOnDiagonal}, {"splay", [](auto& p) { return isAtTwo(p) && p[1] <= 0.0; }}}, 2);
  const auto one = split(mesh), other = split(renumbered(mesh));
  expectGoodSplit(renumbered(mesh), other);
  EXPECT_EQ(cellsOnPlusSides(one), cellsOnPlusSides(other));
  EXPECT_GT(cellsOnPlusSides(one).size(), 20u);
}

TEST(SplitFaults, RefusesFaultsThatMeet)
{
  // Of these three none goes on: two pairs bend by 45 degrees.
  expectRefused(faultedRectangle({{"west", [](auto& p) { return isOnXAxis(p) && p[0] <= 2.0; }},
                                  {"east", [](auto& p) { return isOnDiagonal(p) && p[0] >= 2.0; }},
                                  {"down", [](auto& p) { return isAtTwo(p) && p[1] <= 0.0; }}}),
                {"faults 'down', 'east' and 'west' meet at (2, 0)", "where each of them ends"});
  // A node of the surface with three copies.
  expectRefused(faultedRectangle({{"main", [](auto& p) { return isOnXAxis(p); }},
                                  {"other", [](auto& p) { return p[0] == p[1]; }}}),
                {"faults 'main' and 'other' cross at (0, 0)", "3 parts"});
  expectRefused(
    faultedRectangle({{"star", [](auto& p) { return isOnXAxis(p) || isUpwardAtTwo(p); }}}),
    {"3 facets of fault 'star' meet at (2, 0)"});
}

TEST(SplitFaults, RefusesAFaultThatTouchesTheSurface)
{
  expectRefused(
    faultedRectangle(
      {{"bump", [](auto& p) { return std::abs(std::abs(p[0] - 2.0) + p[1] - 2.0) < 1e-9; }}}),
    {"Here: fault 'bump' crosses itself, or touches the boundary of the body and goes on, at (2, "
     "2)",
     "3 parts"});
}

TEST(SplitFaults, RefusesAFaultWithoutANodeThatSlips)
{
  expectRefused(
    faultedRectangle({{"short", [](auto& p) { return isOnXAxis(p) && p[0] >= 1 && p[0] <= 2; }}}),
    {"Here: fault 'short' has no node that could slip; refine the mesh"});
}

TEST(SplitFaults, RefusesBoundariesThatAreNoFaults)
{
  auto mesh = faultedRectangle({{"fault", isOnXAxis}});
  auto mixed = mesh;
  mixed.boundaries["top"].push_back(mesh.boundaries.at("fault")[1]);
  expectRefused(
    mixed, {"Here: boundary 'top' has facets inside the body, one at (1.5, 0)", "on its surface"});
  test::expectRefusal([&] { checkMesh(mixed, "There"); },
                      {"There: boundary 'top' has facets inside"});
  auto twice = mesh;
  twice.boundaries["other"] = {mesh.boundaries.at("fault")[2]};
  expectRefused(twice, {"the facet at (2.5, 0) is in fault", "'fault'", "'other'"});
}

TEST(SplitFaults, RefusesAPeriodicMesh)
{
  auto mesh = rectangleMesh({4.0, 4.0, 4, 4, {0.0, -2.0}});
  makePeriodic(mesh, 0, "left", "right");
  addFaults<2>(mesh, {{"fault", isOnXAxis}});
  expectRefused(mesh, {"Here: a periodic mesh cannot have faults inside"});
}

TEST(SplitFaults, IsSeenByTheCheck)
{
  const auto mesh = split(faultedRectangle({{"fault", isUpwardAtTwo}}));
  checkMesh(mesh, "test");
  const auto refused = [&](auto const& change, std::vector<std::string> const& pieces) {
    auto wrong = mesh;
    change(wrong);
    test::expectRefusal([&] { checkMesh(wrong, "There"); }, pieces);
  };
  refused([](auto& m) { m.splits[1].minus = 0; }, {"There: vertices 26", "not at one place"});
  refused([](auto& m) { std::swap(m.splits[0], m.splits[1]); }, {"ascending"});
  refused(
    [](auto& m) {
      m.splits[1].minus = m.splits[2].plus;
      m.splits[2].minus = m.splits[1].plus;
    },
    {"There: vertices 26, 27 and 26 are each the plus", "follow one another"});
  refused([](auto& m) { m.splits[0].is_tip = !m.splits[0].is_tip; }, {"belongs to no cell"});
  refused([](auto& m) { m.splits.pop_back(); }, {"fault 'fault'", "the plus of no pair"});
  refused([](auto& m) { m.boundaries.at("fault")[0] = {25, 27}; }, {"not a facet of a cell"});
  refused([](auto& m) { m.boundaries.erase("fault"); }, {"not among the boundaries"});
  refused([](auto& m) { m.boundaries["more"] = {{6, 7}}; }, {"not along 'more'"});
}
