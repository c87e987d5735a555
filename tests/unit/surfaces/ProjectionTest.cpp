#include "SurfaceSamples.hpp"

#include "surfaces/Projection.hpp"

using namespace asperity;
using namespace asperity::geometry;

namespace
{
std::array<double, 3> projected(std::string const& definition, double longitude, double latitude)
{
  std::vector<std::array<double, 3>> points = {{longitude, latitude, -7}};
  Projection(definition, "Projection").toPlane(points);
  return points.front();
}

void expectNear(std::array<double, 3> const& point, std::array<double, 3> const& wanted,
                double tolerance)
{
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(point[d], wanted[d], tolerance) << d;
  }
}

#define NEEDS_PROJ()                                                                               \
  if (!Projection::isAvailable()) {                                                                \
    GTEST_SKIP() << "this build has no PROJ";                                                      \
  }
} // namespace

// From the equator to the pole a meridian of WGS 84 is 10 001 965.729 m long.
TEST(Projection, HasTheLengthOfTheMeridian)
{
  NEEDS_PROJ();
  const double quarter = 10001965.729;
  expectNear(projected("+proj=tmerc +lon_0=12 +datum=WGS84", 12, 90), {0, quarter, -7}, 2e-3);
  expectNear(projected("utm11", -117, 0), {500e3, 0, -7}, 1e-3);
  expectNear(projected("UTM 33s", 15, -90), {500e3, 1e7 - 0.9996 * quarter, -7}, 2e-3);
}

TEST(Projection, GoesThereAndBack)
{
  NEEDS_PROJ();
  const Projection utm("EPSG:32611", "Projection");
  std::vector<std::array<double, 3>> points = {{-119, 34, 1}, {-115.5, 36.25, 2}};
  const auto given = points;
  utm.toPlane(points);
  EXPECT_LT(points[0][0], points[1][0]);
  EXPECT_LT(points[0][1], points[1][1]);
  utm.toGeographic(points);
  expectNear(points[0], given[0], 1e-9);
  expectNear(points[1], given[1], 1e-9);
}

// The same projection in US feet and in metres.
TEST(Projection, HasMetresWhateverItsUnitIs)
{
  NEEDS_PROJ();
  expectNear(projected("EPSG:2229", -118, 34), projected("EPSG:26945", -118, 34), 1e-3);
}

TEST(Projection, IsRefused)
{
  NEEDS_PROJ();
  test::expectRefusal([] { Projection("EPSG:4326", "Asperity / Projection"); },
                      {"Asperity / Projection = 'EPSG:4326'", "no projection to a plane"});
  test::expectRefusal([] { Projection("nonsense", "Projection"); },
                      {"no coordinate system", "utm11"});
  test::expectRefusal([] { Projection("utm99", "Projection"); },
                      {"'utm99'", "no coordinate system"});
  test::expectRefusal([] { projected("utm11", 450000, 3700000); },
                      {"longitude 450000", "Are these degrees"});
}

TEST(Projection, IsRefusedByABuildWithoutIt)
{
  if (Projection::isAvailable()) {
    GTEST_SKIP() << "this build has PROJ";
  }
  test::expectRefusal([] { Projection("utm11", "Projection"); }, {"no projections", "libproj-dev"});
}
