#include "catalogue/fault_geometry/FaultPlaces.hpp"
#include "unit/io/Support.hpp"

using namespace asperity;
using namespace asperity::catalogue;
using test::world;

namespace
{
// The strip, turned so that its base, the fault, is the line from (0, -1) up to (0, 0).
io::OutputDomain uprightFault(int num_base)
{
  auto mesh = test::stripMesh(num_base);
  for (auto& vertex : mesh.vertices) {
    vertex = {-vertex[1], vertex[0] - 1};
  }
  return io::boundaryDomain("fault", mesh, "base", world());
}
} // namespace

TEST(FaultPlaces, DistancesAreDownDip)
{
  const auto upright = uprightFault(4);
  const auto level = io::boundaryDomain("fault", test::stripMesh(4), "base", world());
  const auto along_upright = faultAxis(upright), along_level = faultAxis(level);
  EXPECT_FALSE(along_upright.is_level);
  EXPECT_TRUE(along_level.is_level);
  ASSERT_EQ(along_upright.distances.size(), upright.numOwned());
  for (std::size_t i = 0; i < upright.numOwned(); ++i) { // the nodes are numbered from below
    EXPECT_NEAR(along_upright.distances[i], -upright.coordinates[2 * i + 1], 1e-15);
  }
  for (std::size_t i = 0; i < level.numOwned(); ++i) {
    EXPECT_NEAR(along_level.distances[i], level.coordinates[2 * i], 1e-15);
  }
}

TEST(FaultPlaces, APointIsFoundByItsDistance)
{
  const auto upright = pointAlong(uprightFault(4), 0.3); // between nodes
  ASSERT_TRUE(upright);
  EXPECT_NEAR((*upright)[0], 0, 1e-15);
  EXPECT_NEAR((*upright)[1], -0.3, 1e-15);
  const auto level = io::boundaryDomain("fault", test::stripMesh(4), "base", world());
  EXPECT_NEAR((*pointAlong(level, 1))[0], 1, 1e-15);
  EXPECT_FALSE(pointAlong(level, 1.001) || pointAlong(level, -0.001));
}
