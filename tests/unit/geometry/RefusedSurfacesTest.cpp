#include "SampleSurfaces.hpp"

#include "arrangement/preparation/CheckedSurface.hpp"

#include "base/Errors.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace asperity::geometry;

namespace
{
// The message of the refusal; "" if there is none.
template <class Call>
std::string refusal(Call const& call)
{
  try {
    call();
  } catch (asperity::InputError const& error) {
    return error.what();
  }
  return "";
}

void expectWords(std::string const& message, std::vector<std::string> const& words)
{
  for (auto const& word : words) {
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
  }
}

std::string refusalOf(std::vector<NamedSurface> const& faults, TriangleSurface const& ground = {})
{
  return refusal([&] { arrangeSurfaces(settings(faults, wideBox(), km, 6 * km, ground)); });
}

TEST(Refused, CoplanarOverlap)
{
  // It continues `main` and overlaps it by 1 km around x = 14.5 km.
  const NamedSurface twin = {
    "twin", planeSurface({14 * km, 0, -1 * km}, {10 * km, 0, 0}, {0, 0, -5 * km}, 1, 1)};
  expectWords(refusalOf({mainFault(), twin}), {"'main'", "'twin'", "overlap", "(1", " km"});
}

TEST(Refused, SelfCrossing)
{
  // Two sheets of one surface, which cross at x = 1 km.
  TriangleSurface both = planeSurface({0, 1 * km, -1 * km}, {5 * km, 0, 0}, {0, 0, -5 * km}, 1, 1);
  const auto other = planeSurface({1 * km, 0, -1 * km}, {0, 5 * km, 0}, {0, 0, -5 * km}, 1, 1);
  for (auto triangle : other.triangles) {
    for (int& v : triangle) {
      v += 4;
    }
    both.triangles.push_back(triangle);
  }
  both.points.insert(both.points.end(), other.points.begin(), other.points.end());
  expectWords(refusalOf({{"folded", both}}), {"'folded'", "itself", " km"});
}

TEST(Refused, FoldAtACommonEdge)
{
  const TriangleSurface fold = {
    {{0, 0, -1 * km}, {km, 0, -1 * km}, {0, 0, -3 * km}, {km, 0, -2 * km}}, {{0, 1, 2}, {0, 1, 3}}};
  expectWords(refusalOf({{"flat_fold", fold}}), {"'flat_fold'", "itself"});
}

TEST(Refused, FaultOutsideTheBox)
{
  const NamedSurface far = {
    "far", planeSurface({100 * km, 0, -1 * km}, {5 * km, 0, 0}, {0, 0, -5 * km}, 1, 1)};
  expectWords(refusalOf({mainFault(), far}), {"'far'", "not inside", "x from 100 to 105"});
}

TEST(Refused, FaultAboveTheGround)
{
  const NamedSurface above = {"above",
                              planeSurface({0, 0, 6 * km}, {5 * km, 0, 0}, {0, 0, -5 * km}, 1, 1)};
  expectWords(refusalOf({above}), {"'above'", "above the ground"});
}

TEST(Refused, GroundThatEndsInsideTheBox)
{
  const auto small = planeSurface({-30 * km, -40 * km, 0}, {80 * km, 0, 0}, {0, 80 * km, 0});
  expectWords(refusalOf({mainFault()}, small), {"'ground'", "ends at (", "Margin"});
}

TEST(Refused, GroundWithAHole)
{
  auto ground = planeSurface({-50 * km, -50 * km, 0}, {100 * km, 0, 0}, {0, 100 * km, 0}, 20, 20);
  ground.triangles.erase(ground.triangles.begin() + 450);
  expectWords(refusalOf({mainFault()}, ground), {"'ground'", "ends at"});
}

TEST(Refused, GroundBelowTheBottom)
{
  const auto deep =
    planeSurface({-50 * km, -50 * km, -40 * km}, {100 * km, 0, 0}, {0, 100 * km, 0});
  EXPECT_NE(refusalOf({mainFault()}, deep), "");
}

TEST(Refused, NumbersThatAreNotFinite)
{
  auto surface = mainFault().surface;
  surface.points[5][2] = std::numeric_limits<double>::quiet_NaN();
  expectWords(refusal([&] { checkedSurface(surface, "Fault 'main'"); }),
              {"Fault 'main'", "point 6", "nan"});
}

TEST(Refused, EmptySurface)
{
  expectWords(refusal([] { checkedSurface({}, "Fault 'main'"); }),
              {"Fault 'main'", "no triangles"});
}

TEST(Refused, PointThatIsNotThere)
{
  expectWords(refusal([] {
                checkedSurface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}, "F");
              }),
              {"F: triangle 1", "point 4"});
}

TEST(Refused, ThreeSheetsAtAnEdge)
{
  const TriangleSurface surface = {{{0, 0, 0}, {km, 0, 0}, {0, km, 0}, {0, -km, 0}, {0, 0, km}},
                                   {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  expectWords(refusal([&] { checkedSurface(surface, "F"); }), {"3 triangles meet", "(1, 0, 0) km"});
}

// At x = 0 the parts x < 0 and x > 0 go on as one sheet, though the branch stands first in the
// list; at x = 2 km another branch leaves to the other side.
TEST(Sheets, GoOnWhereTheyBendLeast)
{
  TriangleSurface tree;
  const auto addStrip = [&](double x0, double y0, double x1, double y1) {
    const auto first = static_cast<int>(tree.points.size());
    for (auto const& [x, y] : {std::pair(x0, y0), std::pair(x1, y1)}) {
      tree.points.push_back({x * km, y * km, 0});
      tree.points.push_back({x * km, y * km, -3 * km});
    }
    tree.triangles.push_back({first, first + 2, first + 3});
    tree.triangles.push_back({first + 3, first + 1, first});
  };
  addStrip(0, 0, 1, 1);
  addStrip(0, 0, -2, 0.1);
  addStrip(2, 0, 0, 0);
  addStrip(2, 0, 5, -0.2);
  addStrip(2, 0, 3, -2);
  const auto sheets = checkedSheets(tree, "F");
  ASSERT_EQ(sheets.size(), 3u);
  const double through = std::hypot(2, 0.1) + 2 + std::hypot(3, 0.2);
  EXPECT_NEAR(areaOf(sheets[0]), through * 3 * km * km, 1);
  EXPECT_NEAR(areaOf(sheets[1]), std::sqrt(5) * 3 * km * km, 1);
  EXPECT_NEAR(areaOf(sheets[2]), std::sqrt(2) * 3 * km * km, 1);
  EXPECT_EQ(sheets[0].points.size(), 8u);
  EXPECT_EQ(checkedSheets(mainFault().surface, "F").size(), 1u);
}

// Two parts that lie side by side without an edge in common stay one fault.
TEST(Sheets, PartsThatDoNotMeetAreOne)
{
  auto both = mainFault().surface;
  const auto number = static_cast<int>(both.points.size());
  const auto other = crossingFault().surface;
  both.points.insert(both.points.end(), other.points.begin(), other.points.end());
  for (auto triangle : other.triangles) {
    for (int& v : triangle) {
      v += number;
    }
    both.triangles.push_back(triangle);
  }
  EXPECT_EQ(checkedSheets(both, "F").size(), 1u);
}

TEST(Refused, MoebiusStrip)
{
  TriangleSurface strip;
  constexpr int number = 12;
  const double pi = std::acos(-1.);
  for (int i = 0; i < number; ++i) {
    const double angle = 2 * pi * i / number;
    for (int side : {-1, 1}) {
      const double r = 5 + side * std::cos(angle / 2);
      strip.points.push_back(
        {r * std::cos(angle), r * std::sin(angle), side * std::sin(angle / 2)});
    }
  }
  for (int i = 0; i < number; ++i) {
    const bool is_last = i + 1 == number;
    const int a = 2 * i, b = a + 1, c = is_last ? 1 : a + 2, d = is_last ? 0 : a + 3;
    strip.triangles.push_back({a, b, d});
    strip.triangles.push_back({a, d, c});
  }
  expectWords(refusal([&] { checkedSurface(strip, "F"); }), {"only one side"});
}

TEST(CheckedSurface, OrientsAndWelds)
{
  // Triangles without common points, with normals up and down.
  const auto plane = planeSurface({0, 0, 0}, {km, 0, 0}, {0, km, 0}, 3, 3);
  TriangleSurface loose;
  for (auto const& triangle : plane.triangles) {
    const int n = static_cast<int>(loose.points.size());
    for (int v : triangle) {
      loose.points.push_back(plane.points[v]);
    }
    loose.triangles.push_back(n % 2 == 0 ? Triangle{n, n + 1, n + 2} : Triangle{n, n + 2, n + 1});
  }
  const auto checked = checkedSurface(loose, "F");
  EXPECT_EQ(checked.points.size(), 16u);
  const double first = normalOf(checked.points, checked.triangles.front())[2];
  for (auto const& triangle : checked.triangles) {
    EXPECT_GT(first * normalOf(checked.points, triangle)[2], 0);
  }
}
} // namespace
