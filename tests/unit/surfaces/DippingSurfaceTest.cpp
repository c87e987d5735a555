#include "SurfaceSamples.hpp"

#include "surfaces/DippingSurface.hpp"

using namespace asperity;
using namespace asperity::geometry;

namespace
{
const double degree = std::acos(-1.) / 180;

// Walks north for 30 km, so that the surface dips to the east.
DippingTrace northward(double dip)
{
  DippingTrace trace;
  trace.trace = {{0, 0, 0}, {0, 30e3, 0}};
  trace.dips = {dip, dip};
  trace.upper_z = 0;
  trace.lower_z = -12e3;
  return trace;
}
} // namespace

TEST(DippingSurface, IsThePlaneWithThatDip)
{
  for (const double dip : {20., 60., 90., 120.}) {
    const auto surface = dippingSurface(northward(dip), "Fault");
    EXPECT_NEAR(areaOf(surface), 30e3 * 12e3 / std::sin(dip * degree), 1e-3) << dip;
    EXPECT_LT(largest(surface, [&](auto const& p) { return p[0] + p[2] / std::tan(dip * degree); }),
              1e-8 * 30e3)
      << dip;
    EXPECT_EQ(extentOf(surface, 2), (std::array<double, 2>{-12e3, 0})) << dip;
  }
}

TEST(DippingSurface, GoesOnAboveATraceThatIsNotAtTheEdge)
{
  auto given = northward(45);
  given.trace = {{0, 0, 1000}, {0, 30e3, 1000}};
  given.upper_z = 2000;
  given.lower_z = -3000;
  const auto surface = dippingSurface(given, "Fault");
  EXPECT_NEAR(extentOf(surface, 0)[0], -1000, 1e-6);
  EXPECT_NEAR(extentOf(surface, 0)[1], 4000, 1e-6);
}

TEST(DippingSurface, KeepsTheDipOnBothSidesOfABend)
{
  auto given = northward(50);
  given.trace.push_back({20e3, 45e3, 0});
  given.dips = {50, 50, 50};
  const auto surface = dippingSurface(given, "Fault");
  for (auto const& triangle : surface.triangles) {
    const auto n = normalOf(surface, triangle);
    EXPECT_NEAR(std::abs(n[2]) / std::hypot(n[0], n[1], n[2]), std::cos(50 * degree), 1e-9);
  }
}

TEST(DippingSurface, HasADipThatVaries)
{
  auto given = northward(90);
  given.dips = {90, 45};
  const auto surface = dippingSurface(given, "Fault");
  for (auto const& point : surface.points) { // cot dip is linear along strike
    EXPECT_NEAR(point[0], -point[2] * point[1] / 30e3, 1e-6);
  }
}

TEST(DippingSurface, FollowsItsDipDirection)
{
  auto given = northward(45);
  given.dip_direction = 270;
  EXPECT_NEAR(extentOf(dippingSurface(given, "Fault"), 0)[0], -12e3, 1e-6);
}

TEST(DippingSurface, HasPointsAtTheSpacing)
{
  auto given = northward(90);
  given.spacing = 3000;
  EXPECT_EQ(dippingSurface(given, "Fault").points.size(), 11u * 5u);
}

TEST(DippingSurface, IsRefusedWhereItFolds)
{
  auto given = northward(30);
  given.trace = {{0, 0, 0}, {0, 10e3, 0}, {1000, 10e3, 0}, {1000, 0, 0}};
  given.dips = {30, 30, 30, 30};
  test::expectRefusal([&] { dippingSurface(given, "Fault"); },
                      {"Fault", "folded", "Dip Direction"});
  given.trace = {{0, 0, 0}, {0, 10e3, 0}, {100, 0, 0}};
  given.dips = {30, 30, 30};
  test::expectRefusal([&] { dippingSurface(given, "Fault"); },
                      {"turns by 179", "point 2", "at most 120"});
  given.trace = {{0, 0, 0}, {0, 0, 0}};
  given.dips = {30, 30};
  test::expectRefusal([&] { dippingSurface(given, "Fault"); }, {"1 and 2", "same place"});
  given = northward(30);
  given.lower_z = 10;
  test::expectRefusal([&] { dippingSurface(given, "Fault"); }, {"not below the upper edge"});
  given.trace.pop_back();
  given.dips.pop_back();
  test::expectRefusal([&] { dippingSurface(given, "Fault"); }, {"1 points", "two or more"});
}

TEST(PlaneSurface, HasItsCorners)
{
  PlaneShape shape;
  shape.top_centre = {100, 200, -1000};
  shape.strike = 90; // to the east, so that it dips to the south
  shape.dip = 30;
  shape.length = 8000;
  shape.width = 2000;
  const auto surface = planeSurface(shape);
  EXPECT_NEAR(areaOf(surface), 16e6, 1e-6);
  EXPECT_NEAR(extentOf(surface, 0)[0], -3900, 1e-9);
  EXPECT_NEAR(extentOf(surface, 0)[1], 4100, 1e-9);
  EXPECT_NEAR(extentOf(surface, 1)[0], 200 - 2000 * std::cos(30 * degree), 1e-9);
  EXPECT_NEAR(extentOf(surface, 1)[1], 200, 1e-9);
  EXPECT_NEAR(extentOf(surface, 2)[0], -2000, 1e-9);
}

TEST(PlaneSurface, GoesOnUpDip)
{
  PlaneShape shape;
  shape.top_centre = {0, 0, -1000};
  shape.dip = 45;
  shape.length = shape.width = 1000;
  const auto extended = extendedUp(shape, 500, "Fault");
  EXPECT_NEAR(extended.width, 1000 + 1500 * std::sqrt(2.), 1e-9);
  EXPECT_NEAR(extended.top_centre[0], -1500, 1e-9); // strikes north, dips east
  EXPECT_EQ(extended.top_centre[2], 500);
  shape.dip = 0;
  test::expectRefusal([&] { extendedUp(shape, 500, "Fault"); }, {"horizontal"});
}
