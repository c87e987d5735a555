#include "SampleSurfaces.hpp"

#include "arrangement/complex/Curves.hpp"
#include "arrangement/complex/EdgeCollapse.hpp"
#include "arrangement/complex/Patches.hpp"
#include "arrangement/complex/TriangleTree.hpp"
#include "arrangement/exact/ExactArrangement.hpp"
#include "arrangement/exact/Rounding.hpp"
#include "building/BuildReport.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace asperity::geometry;
using asperity::Point;

namespace
{
// Areas do not change when triangles are divided.
void expectArea(double area, double expected) { EXPECT_NEAR(area, expected, 1e-9 * expected); }

struct Network
{
  char const* name;
  double beyond; // splayFault
};

class Crossing : public testing::TestWithParam<Network>
{
};

TEST(Arrange, CommonLineOfTwoRectangles)
{
  const auto result = arrange({{"a", planeSurface({-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, 1, 1)},
                               {"b", planeSurface({0.25, -1, -0.5}, {0, 2, 0}, {0, 0, 1}, 1, 1)}});
  expectArea(areaIn(result.complex, 0), 4);
  expectArea(areaIn(result.complex, 1), 2);
  double length = 0;
  for (auto const& curve : findCurves(result.complex)) {
    if (curve.surfaces == std::vector<int>{0, 0, 1, 1}) {
      length += lengthOf(result.complex, curve);
    }
  }
  EXPECT_NEAR(length, 1, 1e-14); // b lies within a there: from z = -0.5 to 0.5
}

TEST(Arrange, ThreePlanesThroughOnePoint)
{
  // Rotated, so that no coordinate is a round number.
  const double a = 0.3, b = 0.7;
  const Point<3> u = {std::cos(a), std::sin(a), 0};
  const Point<3> v = {-std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), std::sin(b)};
  const Point<3> w = asperity::mesh::cross(u, v);
  const auto square = [](Point<3> const& p, Point<3> const& q) {
    return planeSurface(at({}, -1, p, -1, q), {2 * p[0], 2 * p[1], 2 * p[2]},
                        {2 * q[0], 2 * q[1], 2 * q[2]}, 1, 1);
  };
  auto arranged = arrange({{"a", square(u, v)}, {"b", square(v, w)}, {"c", square(w, u)}});
  removeRounding(arranged.complex, 1e-6);
  // One point at which all three meet, by six curves, and twelve quarters of squares there.
  const auto curves = findCurves(arranged.complex);
  std::map<int, int> ends;
  for (auto const& curve : curves) {
    if (curve.surfaces.size() == 4) {
      ++ends[curve.points.front()];
      ++ends[curve.points.back()];
    }
  }
  int centre = -1;
  for (auto const& [v_end, number] : ends) {
    if (number == 6) {
      EXPECT_EQ(centre, -1);
      centre = v_end;
    }
  }
  ASSERT_GE(centre, 0);
  EXPECT_LT(asperity::mesh::distance<3>(arranged.complex.points[centre], {}), 1e-12);
  EXPECT_EQ(findPatches(arranged.complex).list.size(), 12u);
  for (int s = 0; s < 3; ++s) {
    expectArea(areaIn(arranged.complex, s), 4);
  }
}

// Crossing and splay; the splay goes through, ends at `main` up to rounding, stops short.
TEST_P(Crossing, HasTheSameAreas)
{
  const auto given =
    settings({mainFault(), crossingFault(), splayFault(GetParam().beyond)}, wideBox(), km, 6 * km);
  const auto arranged = arrangeSurfaces(given);
  const double splay = 12 * km * 8 * km / std::sqrt(0.75);
  EXPECT_NEAR(areaIn(arranged.complex, 0), 450 * km * km, 1e-6 * km * km);
  EXPECT_NEAR(areaIn(arranged.complex, 1), 240 * km * km, 1e-6 * km * km);
  EXPECT_NEAR(areaIn(arranged.complex, 2), splay, 1e-6 * splay);
  const auto found = junctions(arranged.complex, given.model);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].is_crossing);
  EXPECT_NEAR(found[0].length, 15 * km, 1e-6);
  EXPECT_FALSE(found[1].is_crossing);
  EXPECT_EQ(found[1].first, "main");
  EXPECT_EQ(found[1].second, "splay");
  EXPECT_NEAR(found[1].length, 12 * km, 1e-3);
  EXPECT_NEAR(smallestAngle(arranged.complex, given.model).degrees, 30, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Splays, Crossing,
                         testing::Values(Network{"through", 300}, Network{"exact", 0},
                                         Network{"short", -40}),
                         [](auto const& of) { return std::string(of.param.name); });

TEST(Body, PlaneUnderSinusoidalGround)
{
  // 30 degrees; it leaves the ground, of which it is to keep what lies below.
  const double c = std::sqrt(0.75), s = 0.5;
  const auto height = [](double x, double y) {
    return 300 * std::sin(2 * std::acos(-1.) * x / (7 * km)) *
           std::cos(2 * std::acos(-1.) * y / (9 * km));
  };
  const auto ground = gridSurface(
    [&](double a, double b) {
      const double x = (120 * a - 60) * km, y = (120 * b - 60) * km;
      return Point<3>{x, y, height(x, y)};
    },
    60, 60);
  const NamedSurface thrust = {"thrust",
                               planeSurface({-12 * km, -6 * c * km, 6 * s * km}, {24 * km, 0, 0},
                                            {0, 26 * c * km, -26 * s * km}, 12, 13)};
  const Box box = {{-32 * km, -26 * km, -30 * km}, {32 * km, 38 * km, 0}};
  const auto given = settings({thrust}, box, km, 6 * km, ground);
  const auto arranged = arrangeSurfaces(given);
  // The width below the ground is 20 km from (y, z) = 0 down, and 2 z up to the ground there: the
  // mean over x of the root of z = ground(x, -z/tan 30), by columns of the triangulated ground.
  const TriangleTree tree(ground.points, ground.triangles);
  double sum = 0;
  constexpr int columns = 2000;
  for (int i = 0; i < columns; ++i) {
    const double x = (-12 + 24 * (i + 0.5) / columns) * km;
    double low = -km, high = km; // along the plane, upward; the plane is below the ground at `low`
    for (int k = 0; k < 50; ++k) {
      const double w = 0.5 * (low + high), y = -w * c, z = w * s;
      const bool is_below = tree.isCrossedBy({x, y, z}, {x, y, z + 2 * km});
      (is_below ? low : high) = w;
    }
    sum += 20 * km + low;
  }
  const double expected = sum / columns * 24 * km;
  EXPECT_NEAR(areaIn(arranged.complex, 0), expected, 1e-3 * expected);
  EXPECT_NEAR(areaIn(arranged.complex, 0), expected, 1e-5 * expected); // what columns allow
  for (auto const& piece : arranged.dropped) {
    EXPECT_EQ(piece.reason, Dropped::Reason::outside);
  }
}

TEST(Snap, LeavesABorderThatWouldNotMeetAnything)
{
  // Beside `main`, parallel to it, 50 m away: its border comes near, but points past it.
  const NamedSurface beside = {
    "beside", planeSurface({-5 * km, 50, -5 * km}, {10 * km, 0, 0}, {0, 0, -5 * km}, 5, 5)};
  const auto given = settings({mainFault(), beside}, wideBox(), km, 6 * km);
  const auto arranged = arrangeSurfaces(given);
  EXPECT_EQ(arranged.num_pushed, 0);
  expectArea(areaIn(arranged.complex, 1), 50 * km * km);
}

TEST(EdgeCollapse, ContractsShortCurvesAndKeepsPlanes)
{
  // Two vertical faults and a sloping one meet 30 m below the ground: z = -30 m + 0.7 (x + y).
  const NamedSurface east = {
    "x", planeSurface({0, -10 * km, 2 * km}, {0, 20 * km, 0}, {0, 0, -12 * km}, 20, 12)};
  const NamedSurface slope = {"slope", planeSurface({-8 * km, 6 * km, -1.4 * km - 30},
                                                    {14 * km, -14 * km, 0},
                                                    {3 * km, 3 * km, 4.2 * km}, 20, 6)};
  auto given = settings({mainFault(), east, slope}, wideBox(), km, 6 * km);
  given.snap = 0;
  given.short_share = 0;
  EXPECT_NEAR(shortestCurve(arrangeSurfaces(given).complex).length, 30, 1e-3);
  given.short_share = 0.1;
  const auto arranged = arrangeSurfaces(given);
  EXPECT_GE(arranged.num_contracted, 2);
  EXPECT_GT(shortestCurve(arranged.complex).length, 0.3 * km);
  for (std::size_t i = 0; i < arranged.complex.triangles.size(); ++i) {
    if (arranged.complex.surfaces[i] < 2) { // y = 0 and x = 0
      for (int v : arranged.complex.triangles[i]) {
        EXPECT_NEAR(arranged.complex.points[v][1 - arranged.complex.surfaces[i]], 0, 0.1 * km);
      }
    }
    if (given.model.isGround(arranged.complex.surfaces[i])) {
      for (int v : arranged.complex.triangles[i]) {
        EXPECT_EQ(arranged.complex.points[v][2], 0);
      }
    }
  }
  EXPECT_NEAR(areaIn(arranged.complex, 0), 450 * km * km, 0.1 * km * km);
}

TEST(EdgeCollapse, LeavesCurvesThatLieSideBySide)
{
  // Two vertical faults end at `main`, on its two sides, 30 m apart: joined at one end, their ends
  // would make a wedge of 0.2 degrees.
  const NamedSurface north = {
    "north_branch", planeSurface({0, 0, 2 * km}, {0, 10 * km, 0}, {0, 0, -12 * km}, 10, 12)};
  const NamedSurface south = {
    "south_branch", planeSurface({30, 0, 2 * km}, {0, -10 * km, 0}, {0, 0, -12 * km}, 10, 12)};
  auto given = settings({mainFault(), north, south}, wideBox(), km, 6 * km);
  given.snap = 0;
  const auto arranged = arrangeSurfaces(given);
  EXPECT_EQ(arranged.num_contracted, 0);
  EXPECT_NEAR(shortestCurve(arranged.complex).length, 30, 1e-3);
}

TEST(TriangleTree, NearestAgreesWithSearchOfAll)
{
  std::mt19937 random(7);
  const auto number = [&] { return double(random()) / double(std::mt19937::max()); };
  TriangleSurface soup;
  for (int i = 0; i < 300; ++i) {
    const Point<3> a = {number(), number(), number()};
    for (int k = 0; k < 3; ++k) {
      soup.points.push_back({a[0] + 0.1 * number(), a[1] + 0.1 * number(), a[2] + 0.1 * number()});
    }
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const TriangleTree tree(soup.points, soup.triangles);
  for (int i = 0; i < 200; ++i) {
    const Point<3> x = {number(), number(), number()};
    double smallest = 1;
    for (int t = 0; t < 300; ++t) {
      smallest = std::min(smallest, tree.distance(t, x));
    }
    const auto nearest = tree.nearest(x);
    EXPECT_DOUBLE_EQ(nearest.distance, smallest);
    EXPECT_DOUBLE_EQ(tree.distance(nearest.triangle, x), smallest);
    EXPECT_EQ(tree.nearest(x, smallest).triangle, -1);
  }
}

TEST(FaultShape, StrikeAndDip)
{
  // It dips with 30 degrees to the east (+x): strike is north, 0, and the dip to its right.
  const auto plane = planeSurface({0, 0, 0}, {0, 5, 0}, {2 * std::sqrt(0.75), 0, -1});
  const auto shape = shapeOf(plane.points, plane.triangles);
  EXPECT_NEAR(shape.area, 10, 1e-12);
  EXPECT_NEAR(shape.dip, 30, 1e-9);
  EXPECT_NEAR(std::remainder(shape.strike, 360), 0, 1e-9);
}
} // namespace
