#include "BuiltChecks.hpp"

#include "meshing/Features.hpp"

#include "mesh/MeetingFaults.hpp"
#include "mesh/faults/SplitFaults.hpp"

#include "base/Errors.hpp"

using namespace asperity::geometry;
using asperity::Point;

namespace
{
TEST(Built, PlaneUnderSinusoidalGround)
{
  const double c = std::sqrt(0.75), s = 0.5;
  const auto ground = gridSurface(
    [](double a, double b) {
      const double x = (120 * a - 60) * km, y = (120 * b - 60) * km;
      const double turn = 2 * std::acos(-1.);
      return Point<3>{x, y, 300 * std::sin(turn * x / (14 * km)) * std::cos(turn * y / (18 * km))};
    },
    60, 60);
  const NamedSurface thrust = {"thrust",
                               planeSurface({-12 * km, -6 * c * km, 6 * s * km}, {24 * km, 0, 0},
                                            {0, 26 * c * km, -26 * s * km}, 12, 13)};
  const Box box = {{-32 * km, -26 * km, -30 * km}, {32 * km, 38 * km, 0}};
  const auto given = settings({thrust}, box, 2 * km, 8 * km, ground);
  const auto arranged = arrangeSurfaces(given);
  const auto mesh = meshOf(arranged, given);
  expectNames(mesh, given.model);
  expectAngles(mesh, arranged, given.model);
  expectEstimate(mesh, arranged, given);
  const double exact = areaIn(arranged.complex, 0);
  EXPECT_NEAR(areaOf(mesh, "thrust"), exact, 1e-3 * exact);
  for (auto const& facet : mesh.boundaries.at("thrust")) {
    for (int v : facet) { // the plane through the origin with normal (0, s, c)
      EXPECT_NEAR(s * mesh.vertices[v][1] + c * mesh.vertices[v][2], 0, 1e-6 * 24 * km);
    }
  }
  const double volume = 64. * 64 * 30 * km * km * km;
  EXPECT_NEAR(volumeOf(mesh), volume, 1e-3 * volume); // waves of the ground cancel
}

TEST(Built, EdgesAreCountedOnceAndComparedWithABound)
{
  asperity::GlobalMesh<3> mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 12}, {0, 0, -1}};
  mesh.cells = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  const auto edges = edgeLengths(mesh, 12);
  EXPECT_EQ(edges.number, 9u);
  EXPECT_EQ(edges.num_longer, 2u); // from the top to the points on x and y; one has 12 m
  EXPECT_DOUBLE_EQ(edges.shortest.length, 1);
  EXPECT_EQ(edges.shortest.place, (Point<3>{0, 0, -0.5}));
  EXPECT_DOUBLE_EQ(edges.longest.length, std::sqrt(160.));
  EXPECT_EQ(edges.longest.place, (Point<3>{0, 2, 6}));
}

// Two faults of which one ends at the other, all the way to a mesh that is split.
TEST(Built, JointIsSplit)
{
  const auto given = settings({mainFault(), splayFault(300)}, wideBox(), 2 * km, 8 * km);
  const auto arranged = arrangeSurfaces(given);
  auto mesh = meshOf(arranged, given);
  expectNames(mesh, given.model);
  expectAngles(mesh, arranged, given.model);
  expectEstimate(mesh, arranged, given);
  EXPECT_NEAR(areaOf(mesh, "main"), 450 * km * km, 1e-3 * 450 * km * km);
  const double splay = 12 * km * 8 * km / std::sqrt(0.75);
  EXPECT_NEAR(areaOf(mesh, "splay"), splay, 1e-3 * splay);
  EXPECT_NEAR(volumeOf(mesh), 70. * 54 * 30 * km * km * km, 1e-6 * km * km * km * km);
  const auto off =
    largestDistance(mesh.vertices, mesh.boundaries.at("main"), given.model.surfaces[0].surface);
  EXPECT_LT(off.distance, 1e-6 * km);
  asperity::mesh::splitFaults(mesh, "The mesh");
  EXPECT_EQ(mesh.faults, (std::vector<std::string>{"main", "splay"}));
  asperity::mesh::checkMesh(mesh, "The mesh");
}

// Two faults that cross, and a third one that ends at one of them.
TEST(Built, CrossingFaults)
{
  const auto given =
    settings({mainFault(), crossingFault(), splayFault(-40)}, wideBox(), 2 * km, 8 * km);
  const auto arranged = arrangeSurfaces(given);
  auto mesh = meshOf(arranged, given);
  expectNames(mesh, given.model);
  expectAngles(mesh, arranged, given.model);
  expectEstimate(mesh, arranged, given);
  EXPECT_NEAR(areaOf(mesh, "main"), 450 * km * km, 1e-3 * 450 * km * km);
  EXPECT_NEAR(areaOf(mesh, "cross"), 240 * km * km, 1e-3 * 240 * km * km);
  EXPECT_NEAR(volumeOf(mesh), 70. * 54 * 30 * km * km * km, 1e-6 * km * km * km * km);
  asperity::mesh::splitFaults(mesh, "The mesh");
  asperity::mesh::checkMesh(mesh, "The mesh");
  const auto lines = asperity::mesh::crossingLines(mesh);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].faults, (std::array<std::string, 2>{"cross", "main"}));
  EXPECT_GT(lines[0].num_vertices, 5); // 15 km with cells of 2 km, without the tip at the bottom
  for (auto const& end : lines[0].ends) {
    EXPECT_NEAR(end[0], 5 * km, 1e-3 * km);
    EXPECT_NEAR(end[1], 0, 1e-3 * km);
  }
  EXPECT_NEAR(std::max(lines[0].ends[0][2], lines[0].ends[1][2]), 0, 1e-3 * km);
}

// From wall to wall and down to the bottom: the fault divides the box.
TEST(Built, FaultThatDividesTheBox)
{
  const NamedSurface wall = {
    "divide", planeSurface({-40 * km, 1 * km, 5 * km}, {80 * km, 0, 0}, {0, 3 * km, -40 * km})};
  const Box box = {{-20 * km, -15 * km, -20 * km}, {20 * km, 15 * km, 0}};
  const auto given = settings({wall}, box, 3 * km, 6 * km);
  const auto arranged = arrangeSurfaces(given);
  auto mesh = meshOf(arranged, given);
  expectNames(mesh, given.model);
  expectAngles(mesh, arranged, given.model);
  expectEstimate(mesh, arranged, given);
  const double area = 40 * km * 20 * km * std::hypot(1, 3. / 40);
  EXPECT_NEAR(areaOf(mesh, "divide"), area, 1e-6 * area);
  EXPECT_NEAR(volumeOf(mesh), 40. * 30 * 20 * km * km * km, 1e-6 * km * km * km * km);
  asperity::mesh::splitFaults(mesh, "The mesh");
  EXPECT_EQ(mesh.faults.size(), 1u);
}

// A curved surface: facets are within the bound of chords, h^2 kappa / 8 for edges of length h,
// here with edges up to 1.5 h.
TEST(Built, CurvedFaultIsNearTheGivenSurface)
{
  const double radius = 20 * km, h = 1.5 * km;
  const NamedSurface arc = {"arc", gridSurface(
                                     [&](double a, double b) {
                                       const double angle = 0.6 * (a - 0.5);
                                       return Point<3>{radius * std::sin(angle),
                                                       radius * (1 - std::cos(angle)),
                                                       (1 - 11 * b) * km};
                                     },
                                     120, 20)};
  const Box box = {{-20 * km, -15 * km, -20 * km}, {20 * km, 15 * km, 0}};
  const auto given = settings({arc}, box, h, 6 * km);
  const auto arranged = arrangeSurfaces(given);
  const auto mesh = meshOf(arranged, given);
  expectNames(mesh, given.model);
  expectAngles(mesh, arranged, given.model);
  expectEstimate(mesh, arranged, given);
  const auto off =
    largestDistance(mesh.vertices, mesh.boundaries.at("arc"), given.model.surfaces[0].surface);
  EXPECT_LT(off.distance, (1.5 * h) * (1.5 * h) / radius / 8);
  EXPECT_GT(off.distance, 0.1 * h * h / radius / 8); // or else nothing was compared
  const double area = 0.6 * radius * 10 * km;
  EXPECT_NEAR(areaOf(mesh, "arc"), area, 1e-3 * area);
}

// Cells grow with distance as asked: their mean edge beside a fault and far from it.
TEST(Built, SizesFollowTheFault)
{
  const auto given = settings({mainFault()}, wideBox(), 2 * km, 8 * km);
  const auto mesh = meshOf(arrangeSurfaces(given), given);
  const TriangleTree tree(given.model.surfaces[0].surface.points,
                          given.model.surfaces[0].surface.triangles);
  double near = 0, far = 0;
  int num_near = 0, num_far = 0;
  for (auto const& cell : mesh.cells) {
    for (int i = 1; i < 4; ++i) {
      auto const& a = mesh.vertices[cell[0]];
      auto const& b = mesh.vertices[cell[i]];
      const double distance = tree.nearest(a).distance, length = asperity::mesh::distance<3>(a, b);
      if (distance < 0.1 * km) {
        near += length;
        ++num_near;
      } else if (distance > 20 * km) {
        far += length;
        ++num_far;
      }
    }
  }
  EXPECT_NEAR(near / num_near, 2.2 * km, 0.6 * km);
  EXPECT_NEAR(far / num_far, 8 * km, 2 * km);
}

TEST(Refused, ClosedSurface)
{
  TriangleSurface box;
  for (int i = 0; i < 8; ++i) {
    box.points.push_back({(i & 1) * 4 * km, (i & 2) * 2 * km, -5 * km - (i & 4) * km});
  }
  box.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
  const auto given = settings({{"closed", box}}, wideBox(), 2 * km, 8 * km);
  const auto arranged = arrangeSurfaces(given);
  try {
    meshOf(arranged, given);
    FAIL();
  } catch (asperity::InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("'closed' is closed at"), std::string::npos)
      << error.what();
  }
}
} // namespace
