#include "FaultSamples.hpp"

#include "mesh/Crossings.hpp"
#include "mesh/MeetingFaults.hpp"
#include "mesh/MeshQuality.hpp"

#include <cmath>
#include <random>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
bool isOnXAxis(Point<2> const& p) { return p[1] == 0.0; }
bool isAtTwo(Point<2> const& p) { return p[0] == 2.0; }
bool isOnDiagonal(Point<2> const& p) { return p[0] - 2.0 == p[1]; }

// [0, 4] x [-2, 2] with faults along x = 2, whose plus side is the right one, and along y = 0.
GlobalMesh<2> cross(int cells_per_unit = 1)
{
  return faultedRectangle({{"dyke", isAtTwo}, {"main", isOnXAxis}}, cells_per_unit);
}

using Names = std::array<std::string, 2>;

// The cells that have a vertex lie where `is_there` holds at their centroids.
template <class IsThere>
void expectCellsOf(GlobalMesh<2> const& mesh, int vertex, IsThere const& is_there)
{
  int num_cells = 0;
  for (auto const& cell : mesh.cells) {
    if (std::count(cell.begin(), cell.end(), vertex) > 0) {
      EXPECT_TRUE(is_there(centroid(corners(mesh, cell)))) << vertex;
      ++num_cells;
    }
  }
  EXPECT_GT(num_cells, 0) << vertex;
}

void expectRefused(GlobalMesh<2> mesh, std::vector<std::string> const& pieces)
{
  test::expectRefusal([&] { splitFaults(mesh, "Here"); }, pieces);
  EXPECT_TRUE(mesh.splits.empty());
}
} // namespace

TEST(Crossings, GiveEachSectorAVertex)
{
  const auto mesh = goodSplit(cross(), 0, 4 + 4 + 3);
  const auto crossings = crossingsOf(mesh.splits);
  ASSERT_EQ(crossings.size(), 1u);
  auto const& crossing = crossings[0];
  const auto pairs = pairsAt<2>(mesh, {2.0, 0.0});
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(crossing.mean, 12);
  EXPECT_EQ(crossing.plus, (std::array<int, 2>{pairs[0].plus, pairs[1].plus}));
  EXPECT_EQ(crossing.both, pairs[2].plus);
  const auto named = namedCrossings(mesh);
  ASSERT_EQ(named.size(), 1u);
  EXPECT_EQ(named[0].place, (Point<2>{2.0, 0.0}));
  EXPECT_EQ(named[0].faults, (Names{"dyke", "main"}));
  expectCellsOf(mesh, crossing.mean, [](auto const& x) { return x[0] < 2 && x[1] < 0; });
  expectCellsOf(mesh, crossing.plus[0], [](auto const& x) { return x[0] > 2 && x[1] < 0; });
  expectCellsOf(mesh, crossing.plus[1], [](auto const& x) { return x[0] < 2 && x[1] > 0; });
  expectCellsOf(mesh, crossing.both, [](auto const& x) { return x[0] > 2 && x[1] > 0; });
}

TEST(Crossings, KeepSidesNodesAndAreasOfEachFault)
{
  const auto mesh = split(cross(2));
  expectSidesOfFacets(mesh);
  EXPECT_EQ(upOf(mesh, "main"), (Point<2>{0.0, 4.0}));
  EXPECT_EQ(upOf(mesh, "dyke"), (Point<2>{4.0, 0.0}));
  EXPECT_EQ(boundaryVertices(mesh, "main").size(), 9u);
  EXPECT_EQ(boundaryVertices(mesh, "dyke").size(), 9u);
  const auto crossing = crossingsOf(mesh.splits).at(0);
  const auto faults = namedCrossings(mesh).at(0).faults;
  for (int k : {0, 1}) {
    int num_facets = 0;
    for (auto const& [name, facets] : mesh.boundaries) {
      for (auto const& facet : facets) {
        const bool has_it = std::count(facet.begin(), facet.end(), crossing.plus[k]) > 0;
        EXPECT_TRUE(!has_it || name == faults[k]) << name;
        EXPECT_EQ(std::count(facet.begin(), facet.end(), crossing.both), 0) << name;
        EXPECT_EQ(std::count(facet.begin(), facet.end(), crossing.mean), 0) << name;
        num_facets += has_it ? 1 : 0;
      }
    }
    EXPECT_EQ(num_facets, 2);
  }
}

TEST(Crossings, OfFaultsAtAnyAngle)
{
  for (auto const& other : {isAtTwo, isOnXAxis}) {
    const auto mesh =
      goodSplit(faultedRectangle({{"main", isOnDiagonal}, {"other", other}}), 0, 4 + 4 + 3);
    expectSidesOfFacets(mesh);
    EXPECT_EQ(namedCrossings(mesh).size(), 1u);
  }
}

TEST(Crossings, NextToTipsAndToEachOther)
{
  const auto is_near = [](auto& p) { return std::abs(p[0] - 2) < 1.5 && std::abs(p[1]) < 1.5; };
  const auto small =
    goodSplit(faultedRectangle({{"dyke", [&](auto& p) { return isAtTwo(p) && is_near(p); }},
                                {"main", [&](auto& p) { return isOnXAxis(p) && is_near(p); }}}),
              4, 3);
  expectSidesOfFacets(small);
  const auto two = goodSplit(
    faultedRectangle(
      {{"main", isOnXAxis}, {"one", [](auto& p) { return p[0] == 1.0; }}, {"two", isAtTwo}}),
    0, 3 + 4 + 4 + 2 * 3);
  expectSidesOfFacets(two);
  ASSERT_EQ(namedCrossings(two).size(), 2u);
  EXPECT_EQ(namedCrossings(two)[0].faults, (Names{"main", "one"}));
  EXPECT_EQ(namedCrossings(two)[1].faults, (Names{"main", "two"}));
}

// A branch beside a crossing has a tip, as everywhere.
TEST(Crossings, BesideABranch)
{
  const auto mesh =
    goodSplit(faultedRectangle({{"dyke", isAtTwo},
                                {"main", isOnXAxis},
                                {"splay", [](auto& p) { return p[0] == 3.0 && p[1] >= 0.0; }}}),
              1, 4 + 4 + 3 + 2);
  expectSidesOfFacets(mesh);
}

TEST(Crossings, DoNotDependOnTheOrderOfFacets)
{
  auto mesh = cross();
  const auto one = split(mesh);
  for (auto const* name : {"dyke", "main"}) {
    auto& facets = mesh.boundaries.at(name);
    std::reverse(facets.begin(), facets.end());
    std::swap(facets[0][0], facets[0][1]);
  }
  const auto other = split(mesh);
  EXPECT_EQ(one.cells, other.cells);
  EXPECT_EQ(one.splits, other.splits);
  EXPECT_EQ(namedCrossings(one)[0].faults, namedCrossings(other)[0].faults);
}

namespace
{
bool isEast(Point<2> const& p) { return isOnXAxis(p) && p[0] >= 2.0; }
bool isWest(Point<2> const& p) { return isOnXAxis(p) && p[0] <= 2.0; }
bool isUp(Point<2> const& p) { return isAtTwo(p) && p[1] >= 0.0; }
bool isDown(Point<2> const& p) { return isAtTwo(p) && p[1] <= 0.0; }
bool isUpEast(Point<2> const& p) { return isOnDiagonal(p) && p[1] >= 0.0; }
bool isDownWest(Point<2> const& p) { return isOnDiagonal(p) && p[1] <= 0.0; }
} // namespace

// What continues straight on under another name is one fault, as under one name.
TEST(Crossings, OfNamesThatContinueEachOther)
{
  const auto mesh =
    goodSplit(faultedRectangle({{"dyke", isAtTwo}, {"east", isEast}, {"west", isWest}}), 0, 11);
  expectSidesOfFacets(mesh);
  const auto with_one_name = split(cross());
  EXPECT_EQ(mesh.cells, with_one_name.cells);
  EXPECT_EQ(mesh.splits, with_one_name.splits);
  const auto named = namedCrossings(mesh);
  ASSERT_EQ(named.size(), 1u);
  EXPECT_EQ(named[0].faults, (Names{"dyke", "east/west"}));
  const int plus = crossingsOf(mesh.splits)[0].plus[1];
  for (auto const* name : {"east", "west"}) {
    const auto vertices = boundaryVertices(mesh, name);
    EXPECT_TRUE(std::binary_search(vertices.begin(), vertices.end(), plus)) << name;
    EXPECT_EQ(upOf(mesh, name), (Point<2>{0.0, 2.0}));
  }
}

TEST(Crossings, OfFourNames)
{
  const auto mesh = goodSplit(
    faultedRectangle({{"east", isEast}, {"north", isUp}, {"south", isDown}, {"west", isWest}}), 0,
    11);
  expectSidesOfFacets(mesh);
  const auto named = namedCrossings(mesh);
  ASSERT_EQ(named.size(), 1u);
  EXPECT_EQ(named[0].faults, (Names{"east/west", "north/south"}));
}

// What bends by 45 degrees at another fault does not go on: each ends there with a tip.
TEST(Crossings, AreNoneOfBranches)
{
  const auto on_both_sides = goodSplit(
    faultedRectangle({{"east", isEast}, {"main", isAtTwo}, {"west", isDownWest}}), 2, 5 + 2 + 2);
  expectSidesOfFacets(on_both_sides);
  EXPECT_TRUE(crossingsOf(on_both_sides.splits).empty());
  auto pairs = pairsAt<2>(on_both_sides, {2.0, 0.0});
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_FALSE(pairs[0].is_tip);
  EXPECT_EQ(pairs[1].minus, pairs[0].plus);  // of 'east', beyond the plus side of 'main'
  EXPECT_EQ(pairs[2].minus, pairs[0].minus); // of 'west'
  EXPECT_TRUE(pairs[1].is_tip && pairs[2].is_tip);

  const auto on_one_side = goodSplit(
    faultedRectangle({{"main", isOnXAxis}, {"one", isUp}, {"two", isUpEast}}), 2, 5 + 2 + 2);
  expectSidesOfFacets(on_one_side);
  pairs = pairsAt<2>(on_one_side, {2.0, 0.0});
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[1].minus, pairs[0].plus);
  EXPECT_EQ(pairs[2].minus, pairs[0].plus);
}

// Three names end in one place: the two that bend least go on, by 0 and by 45 degrees.
TEST(Crossings, AreNoneOfThreeEnds)
{
  const auto bent = [](auto const& first) {
    return faultedRectangle({{"a", first}, {"b", isWest}, {"branch", isUp}});
  };
  for (auto const& mesh : {bent(isEast), bent(isUpEast)}) {
    const auto result = goodSplit(mesh, 1, 5 + 2);
    expectSidesOfFacets(result);
    const auto pairs = pairsAt<2>(result, {2.0, 0.0});
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_FALSE(pairs[0].is_tip);
    EXPECT_TRUE(pairs[1].is_tip);
    EXPECT_EQ(pairs[1].minus, pairs[0].plus);
    const auto branch = boundaryVertices(result, "branch");
    EXPECT_TRUE(std::binary_search(branch.begin(), branch.end(), pairs[1].plus));
  }
  // 45, 180 and 270 degrees: two pairs bend alike.
  expectRefused(faultedRectangle({{"a", isUpEast}, {"b", isWest}, {"c", isDown}}),
                {"Here: faults 'a', 'b' and 'c' meet at (2, 0)", "the straightest pair"});
}

TEST(Crossings, RefuseWhatHasMoreThanTwoFaults)
{
  expectRefused(faultedRectangle({{"dyke", isAtTwo}, {"main", isOnXAxis}, {"third", isOnDiagonal}}),
                {"Here: faults 'dyke', 'main' and 'third' cross at (2, 0)", "6 parts",
                 "two faults cross inside the body"});
  expectRefused(faultedRectangle({{"dyke", isAtTwo}, {"main", isOnXAxis}, {"third", isUpEast}}),
                {"Here: faults 'dyke', 'main' and 'third' cross at (2, 0)", "5 parts",
                 "no other one is there"});
  expectRefused(faultedRectangle({{"star", [](auto& p) { return isOnXAxis(p) || isAtTwo(p); }}}),
                {"4 facets of fault 'star' meet at (2, 0)"});
}

// > and < that have their corners in common.
TEST(Crossings, RefuseFaultsThatTouch)
{
  const auto corner = [](double side) {
    return [side](auto& p) { return side * (p[0] - 2.0) == std::abs(p[1]); };
  };
  expectRefused(faultedRectangle({{"one", corner(-1.0)}, {"other", corner(1.0)}}),
                {"Here: faults 'one' and 'other' touch each other at (2, 0)", "Separate them"});
}

TEST(Crossings, AreSeenByTheCheck)
{
  const auto mesh = split(cross());
  const auto crossing = crossingsOf(mesh.splits).at(0);
  const auto refused = [&](auto const& change, std::vector<std::string> const& pieces) {
    auto wrong = mesh;
    change(wrong);
    test::expectRefusal([&] { checkMesh(wrong, "There"); }, pieces);
  };
  // Another copy of the vertex that nothing needs but a cell.
  refused(
    [&](auto& m) {
      m.vertices.push_back(m.vertices[crossing.mean]);
      m.splits.push_back({static_cast<int>(m.vertices.size()) - 1, crossing.mean, false});
      for (auto& cell : m.cells) {
        const auto found = std::find(cell.begin(), cell.end(), crossing.both);
        if (found != cell.end()) {
          *found = m.splits.back().plus;
          break;
        }
      }
    },
    {"There: vertex 12 at (2, 0) is the minus of 4 pairs", "three where two faults cross"});
  // A facet with the vertex of the other fault would have its sides in other sectors.
  refused(
    [&](auto& m) {
      for (auto& facet : m.boundaries.at("main")) {
        if (facet[0] == crossing.plus[1]) {
          facet[0] = crossing.plus[0];
        }
      }
    },
    {"the facet of fault 'main' at (2.5, 0) is not a facet of a cell on both sides"});
}

namespace
{
// Squares of two triangles with parallel diagonals: edges run along (1, 0), (0, 1) and (1, 1).
GlobalMesh<2> slanted(int cells)
{
  auto mesh = rectangleMesh({1.0 * cells, 1.0 * cells, cells, cells, {0.0, 0.0}});
  mesh.cells.clear();
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, d = a + cells + 1;
      mesh.cells.push_back({a, a + 1, d + 1});
      mesh.cells.push_back({a, d + 1, d});
    }
  }
  return mesh;
}

// Straight faults at random places, of random length, along random edges.
GlobalMesh<2> withNetwork(GlobalMesh<2> mesh, int cells, std::mt19937& random)
{
  const auto choose = [&random](int first, int last) {
    return std::uniform_int_distribution<int>(first, last)(random);
  };
  std::set<std::array<int, 2>> used;
  const int num_faults = choose(2, 5);
  for (int fault = 0; fault < num_faults; ++fault) {
    constexpr int directions[3][2] = {{1, 0}, {0, 1}, {1, 1}};
    auto const& direction = directions[choose(0, 2)];
    int i = choose(1, cells / 2), j = choose(1, cells / 2);
    auto& facets = mesh.boundaries["fault " + std::to_string(fault)];
    for (int length = choose(2, cells - 2); length > 0; --length) {
      const int next_i = i + direction[0], next_j = j + direction[1];
      if (next_i >= cells || next_j >= cells) {
        break;
      }
      const std::array<int, 2> facet = {j * (cells + 1) + i, next_j * (cells + 1) + next_i};
      if (used.insert(facet).second) {
        facets.push_back(facet);
      }
      i = next_i;
      j = next_j;
    }
    if (facets.empty()) {
      mesh.boundaries.erase("fault " + std::to_string(fault));
    }
  }
  return mesh;
}

// Vertices through which two straight lines of faults go, and at which no other one ends. Each
// vertex is a number, and so is a direction: the difference of two.
std::set<int> expectedCrossings(GlobalMesh<2> const& mesh)
{
  std::map<int, std::set<int>> directions_at;
  for (auto const& [name, facets] : mesh.boundaries) {
    if (name.rfind("fault", 0) == 0) {
      for (auto const& [a, b] : facets) {
        directions_at[a].insert(b - a);
        directions_at[b].insert(a - b);
      }
    }
  }
  std::set<int> crossings;
  for (auto const& [vertex, directions] : directions_at) {
    const bool go_on =
      std::all_of(directions.begin(), directions.end(),
                  [there = &directions](int direction) { return there->count(-direction) > 0; });
    if (directions.size() == 4 && go_on) {
      crossings.insert(vertex);
    }
  }
  return crossings;
}
} // namespace

TEST(Crossings, InRandomNetworks)
{
  constexpr int cells = 9;
  const auto mesh = slanted(cells);
  std::mt19937 random(1);
  int num_split = 0;
  std::size_t num_crossings = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    SCOPED_TRACE(trial);
    const auto faulted = withNetwork(mesh, cells, random);
    auto result = faulted;
    try {
      splitFaults(result, "Here");
    } catch (InputError const& error) {
      EXPECT_EQ(std::string(error.what()).rfind("Here: ", 0), 0u);
      continue;
    }
    ++num_split;
    expectGoodSplit(faulted, result);
    expectSidesOfFacets(result);
    std::set<int> found;
    for (auto const& crossing : crossingsOf(result.splits)) {
      found.insert(crossing.mean);
    }
    EXPECT_EQ(found, expectedCrossings(faulted));
    num_crossings += found.size();
  }
  EXPECT_GT(num_split, 300);
  EXPECT_GT(num_crossings, 300u);
}
