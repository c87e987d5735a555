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
  const auto upright = faultAxis(uprightFault(4));
  const auto level = faultAxis(io::boundaryDomain("fault", test::stripMesh(4), "base", world()));
  EXPECT_FALSE(upright.is_level);
  EXPECT_TRUE(level.is_level);
  if (world()->getRank() == 0) {
    ASSERT_EQ(upright.distances.size(), 4u); // the nodes are numbered from below
    EXPECT_NEAR(upright.distances[0], 1, 1e-15);
    EXPECT_NEAR(upright.distances[1], 8.0 / 9, 1e-15);
    EXPECT_NEAR(upright.distances[3], 0, 1e-15);
    EXPECT_NEAR(level.distances[1], 1.0 / 9, 1e-15);
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
