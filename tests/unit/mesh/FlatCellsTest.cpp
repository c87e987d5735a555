#include "MeshSamples.hpp"

#include "base/Errors.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/FlatCells.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
// A box with a fault inside, z = 0 for x < 0, that ends at x = 0; cells of 1 m.
GlobalMesh<3> boxWithFault()
{
  auto mesh = boxMesh({{8, 4, 32}, {8, 4, 32}, {-4, 0, -16}});
  addFaults<3>(mesh,
               {{"fault", [](Point<3> const& x) { return std::abs(x[2]) < 1e-9 && x[0] < 1e-9; }}},
               "Faults");
  return mesh;
}
} // namespace

// 0.3, 0.45, 0.675 m above and below; what is far does not move.
TEST(FlatCells, LieOnBothSidesOfAFaultInside)
{
  auto const before = boxWithFault();
  auto mesh = before;
  flattenBeside(mesh, {"fault"}, 0.3, "Mesh");
  EXPECT_NO_THROW(checkMesh(mesh, "mesh"));
  EXPECT_NEAR(cellSizes(mesh).measure, 8 * 4 * 32, 1e-9);
  int beside = 0;
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    auto const &x = before.vertices[vertex], &now = mesh.vertices[vertex];
    if (x[0] <= 0 && std::abs(x[2]) <= 2) {
      const double layers = std::abs(x[2]);
      EXPECT_NEAR(std::abs(now[2]), 0.6 * (std::pow(1.5, layers) - 1), 1e-12);
      EXPECT_GE(now[2] * x[2], 0);
      ++beside;
    }
    if (std::abs(x[2]) > 9) {
      EXPECT_EQ(now, x);
    }
  }
  EXPECT_EQ(beside, 5 * 5 * 5);
}

// The body keeps its faces: surface and right face of the wedge are planes, its corners stay.
TEST(FlatCells, LeaveTheOuterBoundaryWhereItIs)
{
  WedgeShape shape;
  shape.cell_size = 0.04;
  auto const before = deepWedgeMesh(shape, {0.1, {}, false});
  auto mesh = before;
  flattenBeside(mesh, {"base"}, 0.3, "Mesh");
  expectConforming(mesh);
  EXPECT_NEAR(cellSizes(mesh).measure, cellSizes(before).measure, 1e-12);
  const double tangent = shape.height / shape.length;
  int moved = 0;
  for (int vertex : boundaryVertices(mesh, "surface")) {
    auto const& x = mesh.vertices[vertex];
    EXPECT_NEAR(x[1], tangent * x[0], 1e-12);
  }
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    moved += mesh.vertices[vertex] != before.vertices[vertex] ? 1 : 0;
  }
  EXPECT_GT(moved, 10);
}

TEST(FlatCells, RefuseAnUnknownName)
{
  auto mesh = boxWithFault();
  try {
    flattenBeside(mesh, {"falut"}, 0.3, "Mesh / Flat Cells Beside");
    FAIL();
  } catch (InputError const& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("Mesh / Flat Cells Beside"), 0u);
    EXPECT_NE(message.find("'falut'"), std::string::npos);
    EXPECT_NE(message.find("'fault'"), std::string::npos);
  }
}

TEST(FlatCells, LieBesideABoundaryInThePlane)
{
  auto mesh = rectangleMesh({4, 16, 4, 16});
  flattenBeside(mesh, {"bottom"}, 0.5, "Mesh");
  expectConforming(mesh);
  double lowest = 16;
  for (auto const& x : mesh.vertices) {
    lowest = x[1] > 0 ? std::min(lowest, x[1]) : lowest;
  }
  EXPECT_NEAR(lowest, 0.5, 1e-12);
}

TEST(FlatCells, RefuseAPeriodicMesh)
{
  auto mesh = boxMesh({{2, 2, 4}, {2, 2, 4}, {}});
  makePeriodic(mesh, 2, "front", "back");
  EXPECT_THROW(flattenBeside(mesh, {"bottom"}, 0.3, "Mesh"), InputError);
}
