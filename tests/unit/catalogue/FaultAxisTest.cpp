#include "catalogue/fault_geometry/FaultAxis.hpp"
#include "unit/io/Support.hpp"

using namespace asperity;
using namespace asperity::catalogue;
using test::world;

namespace
{
io::OutputDomain uprightFault()
{
  return io::boundaryDomain("fault", test::uprightStrip(4), "base", world());
}
} // namespace

TEST(FaultAxis, PositionsAreDownDip)
{
  const auto upright = uprightFault();
  const auto level = io::boundaryDomain("fault", test::stripMesh(4), "base", world());
  EXPECT_FALSE(faultAxis(upright).is_level);
  EXPECT_TRUE(faultAxis(level).is_level);
  for (std::size_t i = 0; i < upright.numOwned(); ++i) {
    EXPECT_NEAR(upright.positions[i], -upright.coordinates[2 * i + 1], 1e-15);
  }
  for (std::size_t i = 0; i < level.numOwned(); ++i) {
    EXPECT_NEAR(level.positions[i], level.coordinates[2 * i], 1e-15);
  }
}

// The base of the strip from (0, 0) in a direction; a tangent points along +x, or along +y where
// its part along x would be less than 0.4.
TEST(FaultAxis, ATangentRisesAsTheFaultDoesUnlessItIsSteep)
{
  const auto tangentRises = [](double x, double y) {
    auto mesh = test::stripMesh(4);
    for (auto& vertex : mesh.vertices) {
      vertex = {vertex[0] * x - vertex[1] * y, vertex[0] * y + vertex[1] * x};
    }
    return faultAxis(io::boundaryDomain("fault", mesh, "base", world())).tangent_rises;
  };
  EXPECT_FALSE(tangentRises(1, 0)) << "level";
  EXPECT_TRUE(tangentRises(0.8, 0.6));
  EXPECT_FALSE(tangentRises(0.8, -0.6));
  EXPECT_TRUE(tangentRises(0.28, 0.96));
  EXPECT_TRUE(tangentRises(0.28, -0.96)) << "steep, dips to the right";
  EXPECT_TRUE(tangentRises(0, -1));
  EXPECT_TRUE(tangentRises(1e-17, -1)) << "upright but for rounding";
}

TEST(FaultAxis, APointIsFoundByItsDistance)
{
  const auto upright = pointAlong(uprightFault(), 0.3); // between nodes
  ASSERT_TRUE(upright);
  EXPECT_NEAR((*upright)[0], 0, 1e-15);
  EXPECT_NEAR((*upright)[1], -0.3, 1e-15);
  const auto level = io::boundaryDomain("fault", test::stripMesh(4), "base", world());
  EXPECT_NEAR((*pointAlong(level, 1))[0], 1, 1e-15);
  EXPECT_FALSE(pointAlong(level, 1.001) || pointAlong(level, -0.001));
}
