// Rings, and other faults whose parts face each other.
#include "FaultSamples.hpp"

#include "mesh/faults/Facing.hpp"
#include "mesh/parallel/Partition.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <cmath>

namespace asperity::mesh
{
namespace
{
using Line = std::vector<std::array<Point<2>, 2>>;

// The segments between points, of one orientation.
Line line(std::vector<Point<2>> const& points)
{
  Line segments;
  for (std::size_t i = 1; i < points.size(); ++i) {
    segments.push_back({points[i - 1], points[i]});
  }
  return segments;
}

// Counterclockwise around (5, -3), so that the normals point outwards.
std::vector<Point<2>> arc(double degrees)
{
  constexpr int parts = 120;
  std::vector<Point<2>> points;
  for (int i = 0; i <= parts; ++i) {
    const double angle = degrees * M_PI / 180 * i / parts;
    points.push_back({5 + 2 * std::cos(angle), -3 + 2 * std::sin(angle)});
  }
  return points;
}

// Three level strokes, of which the middle one is as long as both others: their normals cancel, and
// the short steps between them leave a mean of 2 * step / (4 + 2 * step) along -x.
std::vector<Point<2>> letterS(double step)
{
  return {{1, step}, {0, step}, {0, 0}, {2, 0}, {2, -step}, {1, -step}};
}

// In [0, 4] x [-2, 2] with cells of 1/4.
GlobalMesh<2> withRingAndLine()
{
  return split(faultedRectangle({{"line", [](Point<2> const& x) { return x[1] == -1.5; }},
                                 {"ring",
                                  [](Point<2> const& x) {
                                    return std::abs(std::max(std::abs(x[0] - 2), std::abs(x[1])) -
                                                    1) < 1e-9;
                                  }}},
                                4));
}
} // namespace

TEST(Facing, OfALineIsItsNormal)
{
  auto const facing = facingOf<2>(line({{0, 0}, {3, 0}, {4, 0}}));
  EXPECT_EQ(facing.normal, (std::array<double, 3>{0, -4, 0}));
  EXPECT_EQ(facing.measure, 4);
  EXPECT_TRUE(facing.hasMeanNormal());
  EXPECT_FALSE(facing.partsFaceEachOther());
  EXPECT_FALSE(facing.isRing());
}

TEST(Facing, OfACircleIsARing)
{
  for (const double degrees : {360., 350.}) {
    auto const facing = facingOf<2>(line(arc(degrees)));
    EXPECT_TRUE(facing.partsFaceEachOther());
    EXPECT_TRUE(facing.isRing());
    EXPECT_NEAR(facing.outwards / facing.extent, 1, 0.01) << "n points away from the centre";
  }
  EXPECT_FALSE(facingOf<2>(line(arc(360))).hasMeanNormal());
  EXPECT_FALSE(facingOf<2>(line(arc(180))).isRing());
  auto reversed = arc(360);
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_LT(facingOf<2>(line(reversed)).outwards, 0);
}

TEST(Facing, OfAnSIsNoRing)
{
  auto const facing = facingOf<2>(line(letterS(0.05)));
  EXPECT_NEAR(facing.normal[0], -0.1, 1e-15);
  EXPECT_NEAR(facing.normal[1], 0, 1e-15);
  EXPECT_TRUE(facing.hasMeanNormal());
  EXPECT_TRUE(facing.partsFaceEachOther());
  EXPECT_FALSE(facing.isRing());
  EXPECT_FALSE(facingOf<2>(line(letterS(0.5))).partsFaceEachOther()) << "a mean of 0.2";
}

TEST(Facing, OfACubeIsARing)
{
  // Each face in two triangles whose normals point outwards, and without the upper face.
  std::vector<std::array<Point<3>, 3>> cube;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {0., 1.}) {
      std::array<Point<3>, 4> corners;
      for (int i = 0; i < 4; ++i) {
        corners[i][axis] = side;
        corners[i][(axis + 1) % 3] = i == 1 || i == 2 ? 1 : 0;
        corners[i][(axis + 2) % 3] = i >= 2 ? 1 : 0;
      }
      if (side == 0) {
        std::swap(corners[1], corners[3]);
      }
      cube.push_back({corners[0], corners[1], corners[2]});
      cube.push_back({corners[0], corners[2], corners[3]});
    }
  }
  auto const whole = facingOf<3>(cube);
  EXPECT_NEAR(whole.measure, 6, 1e-14);
  EXPECT_NEAR(whole.outwards, 3, 1e-14) << "three times the volume";
  EXPECT_FALSE(whole.hasMeanNormal());
  EXPECT_TRUE(whole.isRing());
  cube.resize(cube.size() - 2);
  EXPECT_FALSE(facingOf<3>(cube).isRing()) << "a box without a lid has a lower side";
}

// The sums over ranks are those of the whole mesh, whoever has a facet.
TEST(Facing, IsTheSameOnAnyNumberOfRanks)
{
  const RCP<const Communicator> world = rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  auto const whole = withRingAndLine();
  auto const part = distribute(whole, *world);
  for (std::string const name : {"line", "ring"}) {
    Line segments;
    for (auto const& facet : whole.boundaries.at(name)) {
      segments.push_back(corners(whole, facet));
    }
    auto const expected = facingOf<2>(segments);
    auto const found = facingOf(part, {name}, *world);
    EXPECT_NEAR(found.normal[0], expected.normal[0], 1e-12);
    EXPECT_NEAR(found.normal[1], expected.normal[1], 1e-12);
    EXPECT_NEAR(found.measure, expected.measure, 1e-12);
    EXPECT_NEAR(found.outwards, expected.outwards, 1e-12);
    EXPECT_NEAR(found.extent, expected.extent, 1e-12);
    EXPECT_EQ(found.isRing(), name == "ring");
  }
  EXPECT_EQ(facingOf(part, {}, *world).measure, 0);
}
} // namespace asperity::mesh
