#include "FaultSamples.hpp"

#include "mesh/MeetingFaults.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
bool isFlat(Point<3> const& p) { return p[1] == 0.0; }
bool isUpward(Point<3> const& p) { return p[0] == 2.0 && p[1] >= 0.0; }
bool isBetween(double x, double low, double high) { return low <= x && x <= high; }

void expectRefused(GlobalMesh<3> mesh, std::vector<std::string> const& pieces)
{
  test::expectRefusal([&] { splitFaults(mesh, "Here"); }, pieces);
}

// Five triangles i, i + 1, i + 2 (modulo 5) are a Moebius band; each between two cells of its own.
GlobalMesh<3> moebiusBand()
{
  GlobalMesh<3> mesh;
  const double angle = 2.0 * std::acos(-1.0) / 5.0;
  for (int v = 0; v < 5; ++v) {
    mesh.vertices.push_back({std::cos(v * angle), std::sin(v * angle), 0.1 * v * v});
  }
  for (int v = 0; v < 5; ++v) {
    const GlobalMesh<3>::Facet facet = {v, (v + 1) % 5, (v + 2) % 5};
    mesh.boundaries["band"].push_back(facet);
    for (double side : {1.0, -1.0}) {
      mesh.cells.push_back({facet[0], facet[1], facet[2], static_cast<int>(mesh.vertices.size())});
      auto apex = centroid(corners(mesh, facet));
      apex[2] += side;
      mesh.vertices.push_back(apex);
    }
  }
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  mesh.region_names = {"rock"};
  return mesh;
}
} // namespace

TEST(SplitFaults3D, CutsTheWholeBox)
{
  const auto mesh = goodSplit(faultedBox({{"fault", isFlat}}), 0, 25);
  EXPECT_EQ(mesh.boundaries.at("fault").size(), 32u);
  EXPECT_NEAR(upOf(mesh, "fault")[1], 16.0, 1e-12);
  for (auto const& pair : mesh.splits) {
    for (auto const& cell : mesh.cells) {
      const double y = centroid(corners(mesh, cell))[1];
      EXPECT_TRUE(std::count(cell.begin(), cell.end(), pair.plus) == 0 || y > 0.0);
      EXPECT_TRUE(std::count(cell.begin(), cell.end(), pair.minus) == 0 || y < 0.0);
    }
  }
}

// The plane y = x - 2: the hanging wall is above. Vertical ones: larger x, larger z.
TEST(SplitFaults3D, TakesTheUpperSideForPlus)
{
  const auto rising = goodSplit(
    faultedBox({{"fault", [](auto& p) { return std::abs(p[1] - p[0] + 2.0) < 1e-9; }}}), 0, 25);
  EXPECT_NEAR(upOf(rising, "fault")[0], -16.0, 1e-12);
  EXPECT_NEAR(upOf(rising, "fault")[1], 16.0, 1e-12);
  const auto steep = goodSplit(faultedBox({{"fault", [](auto& p) { return p[0] == 2.0; }}}), 0, 25);
  EXPECT_NEAR(upOf(steep, "fault")[0], 16.0, 1e-12);
  const auto across =
    goodSplit(faultedBox({{"fault", [](auto& p) { return p[2] == 1.0; }}}), 0, 25);
  EXPECT_NEAR(upOf(across, "fault")[2], 16.0, 1e-12);
}

TEST(SplitFaults3D, EndsInTipsInsideTheBody)
{
  const auto mesh = goodSplit(
    faultedBox(
      {{"fault",
        [](auto& p) { return isFlat(p) && isBetween(p[0], 1, 3) && isBetween(p[2], 1, 3); }}}),
    8, 1);
  EXPECT_FALSE(pairsAt<3>(mesh, {2.0, 0.0, 2.0}).at(0).is_tip);
}

// A vertical fault of finite length: where its trace on the surface ends there are tips, too.
TEST(SplitFaults3D, ReachesTheSurface)
{
  const auto mesh = goodSplit(
    faultedBox({{"fault", [](auto& p) { return isUpward(p) && isBetween(p[2], 1, 3); }}}), 7, 2);
  EXPECT_FALSE(pairsAt<3>(mesh, {2.0, 2.0, 2.0}).at(0).is_tip);
  EXPECT_TRUE(pairsAt<3>(mesh, {2.0, 2.0, 1.0}).at(0).is_tip);
}

TEST(SplitFaults3D, KeepsTheSideAlongABentFault)
{
  const auto mesh = goodSplit(
    faultedBox({{"flat", [](auto& p) { return isFlat(p) && p[0] <= 2.0; }}, {"ramp", isUpward}}), 0,
    25);
  EXPECT_NEAR(upOf(mesh, "flat")[1], 8.0, 1e-12);
  EXPECT_NEAR(upOf(mesh, "ramp")[0], -8.0, 1e-12);
}

// Where the splay ends at the main fault, each of the three sectors has a vertex.
TEST(SplitFaults3D, GivesABranchJoints)
{
  const auto mesh = goodSplit(faultedBox({{"main", isFlat}, {"splay", isUpward}}), 0, 25 + 10 + 5);
  expectSidesOfFacets(mesh);
  EXPECT_NEAR(upOf(mesh, "splay")[0], 8.0, 1e-12);
  const auto joints = jointsOf(mesh.splits);
  ASSERT_EQ(joints.size(), 5u);
  const auto splay = boundaryVertices(mesh, "splay"), main = boundaryVertices(mesh, "main");
  for (auto const& joint : joints) {
    EXPECT_TRUE(joint.is_on_plus_side);
    EXPECT_EQ(joint.minus, joint.main);
    EXPECT_TRUE(std::binary_search(splay.begin(), splay.end(), joint.plus));
    EXPECT_TRUE(std::binary_search(main.begin(), main.end(), joint.main));
    auto const place = mesh.vertices[joint.plus];
    const auto pairs = pairsAt<3>(mesh, place);
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_TRUE(pairs[0] == (SplitVertex{joint.main, pairs[0].minus}));
    EXPECT_TRUE(pairs[1] == (SplitVertex{joint.plus, joint.main, false, true}));
    std::set<int> seen;
    for (auto const& cell : mesh.cells) {
      const auto x = centroid(corners(mesh, cell));
      const int expected = x[1] < 0.0 ? pairs[0].minus : x[0] > 2.0 ? joint.plus : joint.minus;
      for (int vertex : cell) {
        if (mesh.vertices[vertex] == place) {
          EXPECT_EQ(vertex, expected);
          seen.insert(vertex);
        }
      }
    }
    EXPECT_EQ(seen.size(), 3u);
  }
}

// On the minus side of the main fault, and one on each side of it at the same vertices.
TEST(SplitFaults3D, GivesJointsOnBothSides)
{
  const auto is_downward = [](auto& p) { return p[0] == 2.0 && p[1] <= 0.0; };
  const auto below = goodSplit(faultedBox({{"main", isFlat}, {"splay", is_downward}}), 0, 40);
  expectSidesOfFacets(below);
  for (auto const& joint : jointsOf(below.splits)) {
    EXPECT_FALSE(joint.is_on_plus_side);
    EXPECT_EQ(pairsAt<3>(below, below.vertices[joint.plus]).at(0),
              (SplitVertex{joint.main, joint.minus}));
  }
  const auto both = goodSplit(
    faultedBox(
      {{"above", isUpward},
       {"below", [](auto& p) { return std::abs(p[1] - p[0] + 2.0) < 1e-9 && p[0] <= 2.0; }},
       {"main", isFlat}}),
    0, 25 + 10 + 10 + 2 * 5);
  expectSidesOfFacets(both);
  std::set<int> minuses;
  for (auto const& joint : jointsOf(both.splits)) {
    minuses.insert(joint.minus);
  }
  EXPECT_EQ(minuses.size(), 10u);
}

// The line along which it branches off ends inside the body; there it divides no side of the other,
// and has a tip.
TEST(SplitFaults3D, GivesAShortBranchTips)
{
  const auto mesh =
    goodSplit(faultedBox({{"main", isFlat},
                          {"splay", [](auto& p) { return isUpward(p) && isBetween(p[2], 1, 3); }}}),
              6, 25 + 2 + 1);
  expectSidesOfFacets(mesh);
  for (double z : {1.0, 3.0}) {
    const auto pairs = pairsAt<3>(mesh, {2.0, 0.0, z});
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_TRUE(pairs[1].is_tip);
    EXPECT_EQ(pairs[1].minus, pairs[0].plus);
  }
  EXPECT_TRUE(pairsAt<3>(mesh, {2.0, 0.0, 2.0}).at(1).is_joint);
  const auto lines = jointLines(mesh);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].faults, (std::array<std::string, 2>{"splay", "main"}));
  EXPECT_EQ(lines[0].num_vertices, 1);
  EXPECT_EQ(lines[0].length, 0);
  EXPECT_EQ(lines[0].ends[0], (Point<3>{2.0, 0.0, 2.0}));
  EXPECT_EQ(lines[0].ends[1], lines[0].ends[0]);
  EXPECT_EQ(pairsAt<3>(mesh, {2.0, 0.0, 0.0}).size(), 1u);
}

// Two branches that end on one side at the same line have tips.
TEST(SplitFaults3D, GivesTwoBranchesOnOneSideTips)
{
  const auto mesh = goodSplit(
    faultedBox(
      {{"main", isFlat},
       {"splay", isUpward},
       {"other", [](auto& p) { return std::abs(p[1] - p[0] + 2.0) < 1e-9 && p[0] >= 2.0; }}}),
    2 * 5, 25 + 10 + 10);
  EXPECT_TRUE(jointsOf(mesh.splits).empty());
}

TEST(SplitFaults3D, ChecksItsJoints)
{
  const auto mesh = split(faultedBox({{"main", isFlat}, {"splay", isUpward}}));
  const auto refused = [&](auto const& change) {
    auto changed = mesh;
    change(changed);
    test::expectRefusal([&] { checkMesh(changed, "There"); },
                        {"There: vertex", "belongs to a branch that slips along another fault"});
  };
  const int minus = jointsOf(mesh.splits).at(0).minus;
  refused([&](auto& m) { // the main fault's pair is another joint
    for (auto& pair : m.splits) {
      pair.is_joint = pair.is_joint || pair.plus == minus;
    }
  });
  refused([&](auto& m) { // a joint inside the splay
    for (auto& pair : m.splits) {
      pair.is_joint = pair.is_joint || m.vertices[pair.plus] == Point<3>{2.0, 1.0, 1.0};
    }
  });
}

TEST(SplitFaults3D, RefusesThreeFaultsThatCross)
{
  expectRefused(faultedBox({{"dyke", [](auto& p) { return p[0] == 2.0; }},
                            {"level", [](auto& p) { return p[2] == 2.0; }},
                            {"main", isFlat}}),
                {"Here: faults 'dyke', 'level' and 'main' cross at (2, 0, 2)", "8 parts"});
  const auto is_diagonal = [](auto& p) { return std::abs(p[0] - 2.0 - p[1]) < 1e-9; };
  expectRefused(
    faultedBox(
      {{"diagonal", is_diagonal}, {"dyke", [](auto& p) { return p[0] == 2.0; }}, {"main", isFlat}}),
    {"Here: faults 'diagonal', 'dyke' and 'main' cross at (2, 0, 0)", "6 parts",
     "two faults cross inside the body"});
  expectRefused(faultedBox({{"star", [](auto& p) { return isFlat(p) || isUpward(p); }}}),
                {"3 facets of fault 'star' meet at (2, 0, "});
}

TEST(SplitFaults3D, RefusesATipOnTheBoundary)
{
  expectRefused(faultedBox({{"fault",
                             [](Point<3> const& p) {
                               const bool is_inside =
                                 isBetween(p[0], 0.5, 3.5) && isBetween(p[2], 0.5, 3.5);
                               return isFlat(p) && (is_inside || p == Point<3>{0.0, 0.0, 1.0} ||
                                                    isBetween(p[0], 0.1, 0.9));
                             }}}),
                {"Here: a tip of fault 'fault' lies on the boundary of the body, at (0, 0, 1)"});
}

TEST(SplitFaults3D, RefusesAMoebiusBand)
{
  auto mesh = moebiusBand();
  orientCells(mesh);
  expectRefused(mesh, {"Here: fault 'band' cannot be oriented", "its two sides are exchanged"});
}

TEST(SplitFaults3D, RefusesAFaultWithoutANodeThatSlips)
{
  expectRefused(faultedBox({{"small",
                             [](auto& p) {
                               return isFlat(p) && isBetween(p[0], 1, 2) && isBetween(p[2], 1, 2);
                             }}}),
                {"fault 'small' has no node that could slip"});
}
