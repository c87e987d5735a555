#include "FaultSamples.hpp"

#include "mesh/Crossings.hpp"
#include "mesh/MeetingFaults.hpp"

#include <algorithm>
#include <cmath>
#include <random>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
bool isFlat(Point<3> const& p) { return p[1] == 0.0; }
bool isAtTwo(Point<3> const& p) { return p[0] == 2.0; }
bool isBetween(double x, double low, double high) { return low <= x && x <= high; }

using Names = std::array<std::string, 2>;

// [0, 4] x [-2, 2] x [0, 4] with faults along x = 2, whose plus side has the larger x, and along
// y = 0. The line of the crossing is parallel to the z axis.
GlobalMesh<3> cross() { return faultedBox({{"dyke", isAtTwo}, {"main", isFlat}}); }

// With vertices 1 m apart.
void expectLine(MeetingLine<3> const& line, Names const& faults, std::set<Point<3>> const& ends)
{
  EXPECT_EQ(line.faults, faults);
  EXPECT_EQ((std::set<Point<3>>{line.ends[0], line.ends[1]}), ends);
  EXPECT_NEAR(line.length, distance<3>(line.ends[0], line.ends[1]), 1e-12);
  EXPECT_EQ(line.num_vertices, 1 + std::lround(line.length));
}

std::set<Point<3>> placesOfCrossings(GlobalMesh<3> const& mesh)
{
  std::set<Point<3>> places;
  for (auto const& crossing : crossingsOf(mesh.splits)) {
    places.insert(mesh.vertices[crossing.mean]);
  }
  return places;
}

std::set<Point<3>> onLine(double low, double high)
{
  std::set<Point<3>> places;
  for (double z = low; z <= high; ++z) {
    places.insert({2.0, 0.0, z});
  }
  return places;
}
} // namespace

// Five vertices on the line, two of them on the surface of the body.
TEST(Crossings3D, GiveEachSectorAVertex)
{
  const auto mesh = goodSplit(cross(), 0, 20 + 20 + 5 * 3);
  expectSidesOfFacets(mesh);
  EXPECT_EQ(placesOfCrossings(mesh), onLine(0, 4));
  for (auto const& [place, faults] : namedCrossings(mesh)) {
    EXPECT_EQ(faults, (Names{"dyke", "main"}));
  }
  for (auto const& [mean, plus, both] : crossingsOf(mesh.splits)) {
    std::set<int> seen;
    for (auto const& cell : mesh.cells) {
      const auto x = centroid(corners(mesh, cell));
      const int expected =
        x[0] > 2.0 ? (x[1] > 0.0 ? both : plus[0]) : (x[1] > 0.0 ? plus[1] : mean);
      for (int vertex : cell) {
        if (mesh.vertices[vertex] == mesh.vertices[mean]) {
          EXPECT_EQ(vertex, expected);
          seen.insert(vertex);
        }
      }
    }
    EXPECT_EQ(seen.size(), 4u);
  }
}

TEST(Crossings3D, KeepSidesNodesAndAreasOfEachFault)
{
  const auto mesh = split(cross());
  EXPECT_EQ(upOf(mesh, "main"), (Point<3>{0.0, 16.0, 0.0}));
  EXPECT_EQ(upOf(mesh, "dyke"), (Point<3>{16.0, 0.0, 0.0}));
  const auto dyke = boundaryVertices(mesh, "dyke"), main = boundaryVertices(mesh, "main");
  EXPECT_EQ(dyke.size(), 25u);
  EXPECT_EQ(main.size(), 25u);
  for (auto const& [mean, plus, both] : crossingsOf(mesh.splits)) {
    EXPECT_TRUE(std::binary_search(dyke.begin(), dyke.end(), plus[0]));
    EXPECT_TRUE(std::binary_search(main.begin(), main.end(), plus[1]));
    for (int vertex : {mean, both}) {
      EXPECT_FALSE(std::binary_search(dyke.begin(), dyke.end(), vertex));
      EXPECT_FALSE(std::binary_search(main.begin(), main.end(), vertex));
    }
  }
}

// The dyke ends inside the body above and below, the main fault goes on: it is split there, and the
// dyke has a tip on each side of it.
TEST(Crossings3D, EndWhereOneFaultEnds)
{
  const auto mesh =
    goodSplit(faultedBox({{"dyke", [](auto& p) { return isAtTwo(p) && isBetween(p[2], 1, 3); }},
                          {"main", isFlat}}),
              2 * (4 + 2), 24 + 4 + 3);
  expectSidesOfFacets(mesh);
  EXPECT_EQ(placesOfCrossings(mesh), onLine(2, 2));
  for (double z : {1.0, 3.0}) {
    const auto pairs = pairsAt<3>(mesh, {2.0, 0.0, z});
    ASSERT_EQ(pairs.size(), 3u);
    EXPECT_FALSE(pairs[0].is_tip);
    EXPECT_TRUE(pairs[1].is_tip && pairs[2].is_tip);
    EXPECT_EQ((std::set<int>{pairs[1].minus, pairs[2].minus}),
              (std::set<int>{pairs[0].plus, pairs[0].minus}));
  }
}

// Both end there: the place has one tip.
TEST(Crossings3D, EndWhereBothFaultsEnd)
{
  const auto mesh =
    goodSplit(faultedBox({{"dyke", [](auto& p) { return isAtTwo(p) && isBetween(p[2], 1, 3); }},
                          {"main", [](auto& p) { return isFlat(p) && isBetween(p[2], 1, 3); }}}),
              2 * 9, 4 + 4 + 3);
  expectSidesOfFacets(mesh);
  EXPECT_EQ(placesOfCrossings(mesh), onLine(2, 2));
  EXPECT_EQ(pairsAt<3>(mesh, {2.0, 0.0, 1.0}).size(), 1u);
}

// Below z = 2 the dyke ends at the main fault with joints, above it crosses it. The crossing begins
// at z = 2 with a joint on one side and a tip on the other one.
TEST(Crossings3D, BecomeABranch)
{
  const auto mesh = goodSplit(
    faultedBox({{"dyke", [](auto& p) { return isAtTwo(p) && (p[1] >= 0.0 || p[2] >= 2.0); }},
                {"main", isFlat}}),
    // y < 0 at z = 2; the main fault, the dyke on both sides, crossings, joints at z = 0, 1 and 2
    3, 23 + 2 * 3 + 2 * 5 + 2 * 2 + 3);
  expectSidesOfFacets(mesh);
  EXPECT_EQ(placesOfCrossings(mesh), onLine(3, 4));
  expectLine(crossingLines(mesh).at(0), {"dyke", "main"}, {{2.0, 0.0, 3.0}, {2.0, 0.0, 4.0}});
  const auto lines = jointLines(mesh);
  ASSERT_EQ(lines.size(), 1u);
  expectLine(lines[0], {"dyke", "main"}, {{2.0, 0.0, 0.0}, {2.0, 0.0, 2.0}});
}

TEST(Crossings3D, OfNamesThatContinueEachOther)
{
  const auto is_east = [](auto& p) { return isFlat(p) && p[0] >= 2.0; };
  const auto mesh =
    goodSplit(faultedBox({{"dyke", isAtTwo},
                          {"east", is_east},
                          {"west", [](auto& p) { return isFlat(p) && p[0] <= 2.0; }}}),
              0, 55);
  const auto with_one_name = split(cross());
  EXPECT_EQ(mesh.cells, with_one_name.cells);
  EXPECT_EQ(mesh.splits, with_one_name.splits);
  EXPECT_EQ(namedCrossings(mesh).at(0).faults, (Names{"dyke", "east/west"}));
  // By 45 degrees they bend too much.
  const auto branches = goodSplit(
    faultedBox(
      {{"dyke", isAtTwo},
       {"east", is_east},
       {"west", [](auto& p) { return std::abs(p[1] - p[0] + 2.0) < 1e-9 && p[0] <= 2.0; }}}),
    0, 25 + 10 + 10 + 2 * 5);
  expectSidesOfFacets(branches);
  EXPECT_EQ(jointsOf(branches.splits).size(), 2u * 5u);
  EXPECT_TRUE(placesOfCrossings(branches).empty());
  auto lines = jointLines(branches);
  ASSERT_EQ(lines.size(), 2u);
  std::sort(lines.begin(), lines.end(), [](auto& a, auto& b) { return a.faults < b.faults; });
  expectLine(lines[0], {"east", "dyke"}, {{2.0, 0.0, 0.0}, {2.0, 0.0, 4.0}});
  expectLine(lines[1], {"west", "dyke"}, {{2.0, 0.0, 0.0}, {2.0, 0.0, 4.0}});
}

TEST(Crossings3D, AreOnLines)
{
  const auto lines = crossingLines(
    split(faultedBox({{"dyke", isAtTwo}, {"main", isFlat}, {"other", [](auto& p) {
                                                              return p[0] == 3.0 && p[2] >= 2.0;
                                                            }}})));
  ASSERT_EQ(lines.size(), 2u);
  expectLine(lines[0], {"dyke", "main"}, {{2.0, 0.0, 0.0}, {2.0, 0.0, 4.0}});
  expectLine(lines[1], {"main", "other"}, {{3.0, 0.0, 3.0}, {3.0, 0.0, 4.0}});
}

TEST(Crossings3D, DoNotDependOnTheOrderOfFacets)
{
  auto mesh = cross();
  const auto one = split(mesh);
  for (auto const* name : {"dyke", "main"}) {
    auto& facets = mesh.boundaries.at(name);
    std::reverse(facets.begin(), facets.end());
    for (auto& facet : facets) {
      std::rotate(facet.begin(), facet.begin() + 1, facet.end());
    }
  }
  const auto other = split(mesh);
  EXPECT_EQ(one.cells, other.cells);
  EXPECT_EQ(one.splits, other.splits);
}

TEST(Crossings3D, AreSeenByTheCheck)
{
  auto mesh = split(cross());
  checkMesh(mesh, "There");
  const auto crossing = crossingsOf(mesh.splits).at(0);
  for (auto& facet : mesh.boundaries.at("main")) {
    std::replace(facet.begin(), facet.end(), crossing.plus[1], crossing.plus[0]);
  }
  test::expectRefusal([&] { checkMesh(mesh, "There"); },
                      {"There: the facet of fault 'main' at", "of a cell on both sides"});
}

namespace
{
// A rectangle in the plane x = place (axis 0) or y = place (axis 1), with its extent along the
// other of these two axes and along z.
struct Rectangle
{
  int axis;
  double place, low, high, bottom, top;

  bool has(Point<3> const& p) const
  {
    return p[axis] == place && isBetween(p[1 - axis], low, high) && isBetween(p[2], bottom, top);
  }
  // Whether it goes on at a point of it with this coordinate along a side: the surface of the body
  // is no end.
  static bool goesOn(double x, double from, double to, double size)
  {
    return (from < x || (from == 0.0 && x == 0.0)) && (x < to || (to == size && x == size));
  }
};
} // namespace

TEST(Crossings3D, OfRandomRectangles)
{
  constexpr int size = 5;
  const auto box = boxMesh({{size, size, size}, {size, size, size}, {}});
  std::mt19937 random(1);
  const auto choose = [&random](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  int num_split = 0;
  std::size_t num_crossings = 0;
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    std::array<Rectangle, 2> faults;
    for (int axis : {0, 1}) {
      const int low = choose(0, 2), bottom = choose(0, 2);
      faults[axis] = {axis,         1.0 * choose(1, 4),
                      1.0 * low,    1.0 * choose(low + 2, size),
                      1.0 * bottom, 1.0 * choose(bottom + 2, size)};
    }
    auto const& [a, b] = faults;
    auto faulted = box;
    addFaults<3>(faulted, {{"a", [&](auto& p) { return faults[0].has(p); }},
                           {"b", [&](auto& p) { return faults[1].has(p); }}});
    auto mesh = faulted;
    try {
      splitFaults(mesh, "Here");
    } catch (InputError const& error) {
      EXPECT_EQ(std::string(error.what()).rfind("Here: ", 0), 0u);
      continue;
    }
    ++num_split;
    expectGoodSplit(faulted, mesh);
    expectSidesOfFacets(mesh);
    std::set<Point<3>> expected;
    for (double z = 0; z <= size; ++z) {
      if (a.low < b.place && b.place < a.high && b.low < a.place && a.place < b.high &&
          Rectangle::goesOn(z, a.bottom, a.top, size) &&
          Rectangle::goesOn(z, b.bottom, b.top, size)) {
        expected.insert({a.place, b.place, z});
      }
    }
    EXPECT_EQ(placesOfCrossings(mesh), expected);
    num_crossings += expected.size();
  }
  EXPECT_GT(num_split, 150);
  EXPECT_GT(num_crossings, 40u);
}
