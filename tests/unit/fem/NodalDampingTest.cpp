#include "fem/NodalDamping.hpp"

#include "fem/BoundaryMeasure.hpp"

#include "fem/BodyMatrices.hpp"
#include "fem/BoundaryCells.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::fem
{
using namespace fem::test;

namespace
{
const Material rock = {2000, 5e9, 3e9, 0, 0};
const Material soil = {1000, 2e9, 1e9, 0, 0};

// Rock below soil, y > 1.
std::vector<Material> layers(Mesh<2> const& mesh)
{
  std::vector<Material> materials;
  for (auto const& cell : mesh.cells) {
    double y = 0;
    for (int vertex : cell) {
      y += mesh.vertices[vertex][1] / 3;
    }
    materials.push_back(y < 1 ? rock : soil);
  }
  return materials;
}

// The power that a uniform velocity along the axes loses to the dampers alone.
template <int Components>
double lossOf(Constrained<2> const& body, std::string const& boundary,
              std::array<double, Components> const& velocity)
{
  auto const materials = layers(body.mesh);
  auto const& frames = body.constraints.frames();
  auto const matrices = assembleBody<2>(body.mesh, body.dofs, frames, materials);
  auto const damped =
    withDampers(*matrices.viscosity, body.dofs,
                resistanceOf<2>(body.mesh, absorbingBoundary(boundary), frames, materials));
  EXPECT_EQ(zeroLike(*damped)->getFrobeniusNorm(), 0);
  EXPECT_EQ(withoutZeros(zeroLike(*damped))->getGlobalNumEntries(), 0u);
  EXPECT_EQ(withoutZeros(matrices.stiffness), matrices.stiffness);
  Vector v(body.dofs.owned()), force(body.dofs.owned());
  {
    auto const values = v.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < body.mesh.num_owned; ++node) {
      std::array<double, Components> local{};
      frames.toFrame(node, velocity.data(), local.data());
      for (int c = 0; c < Components; ++c) {
        values(body.dofs.dof(node, c), 0) = local[c];
      }
    }
  }
  damped->apply(v, force);
  Vector of_few(body.dofs.owned());
  withoutZeros(damped)->apply(v, of_few);
  of_few.update(-1, force, 1);
  EXPECT_EQ(of_few.normInf(), 0);
  EXPECT_LT(2 * withoutZeros(damped)->getGlobalNumEntries(), damped->getGlobalNumEntries());
  return v.dot(force);
}
} // namespace

TEST(NodalDamping, HasTheImpedancesOfPlaneWaves)
{
  const double cp_rock = std::sqrt((5e9 + 4e9) / 2000), cs_rock = std::sqrt(3e9 / 2000);
  const double cp_soil = std::sqrt((2e9 + 4e9 / 3) / 1000), cs_soil = std::sqrt(1e9 / 1000);
  const double across = 2000 * cp_rock + 1000 * cp_soil; // of a metre of each
  const double along = 2000 * cs_rock + 1000 * cs_soil;
  for (std::vector<double> const& frame : {std::vector<double>{1, 0}, {1, 2}, {-1, 5}}) {
    const Constrained<2> body(rectangle(), {Condition{"Any", "right", AtRestAlong{frame}}});
    EXPECT_NEAR(lossOf<2>(body, "right", {1, 0}) / across, 1, 1e-14);
    EXPECT_NEAR(lossOf<2>(body, "right", {0, 1}) / along, 1, 1e-14);
    EXPECT_NEAR(lossOf<2>(body, "right", {3, -2}) / (9 * across + 4 * along), 1, 1e-14);
    EXPECT_NEAR(lossOf<2>(body, "top", {0, 1}) / (3 * 1000 * cp_soil), 1, 1e-14);
  }
  const Constrained<2> antiplane(rectangle(), {}, 1);
  EXPECT_NEAR(lossOf<1>(antiplane, "right", {2}) / (4 * along), 1, 1e-14);
}

TEST(BoundaryCells, AverageTheMaterialsOfTheFacets)
{
  const Constrained<2> body(rectangle(), {});
  std::vector<FaultNode> nodes;
  for (auto const& measure : boundaryMeasure(body.mesh, "right", *worldCommunicator())) {
    nodes.push_back({{measure.node}, {}, {}, measure.weight, {}});
  }
  const FaultSurface right("right", nodes, 0, body.constraints.held(), {},
                           OtherSide::rigid_foundation, worldCommunicator());
  auto const materials = materialsAtNodes(body.mesh, right, layers(body.mesh));
  ASSERT_EQ(materials.size(), nodes.size());
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const double y = body.mesh.vertices[nodes[i].copies[0]][1];
    const double rocky = y < 1 - 1e-9 ? 1 : y > 1 + 1e-9 ? 0 : 0.5;
    EXPECT_NEAR(materials[i].density, 1000 + 1000 * rocky, 1e-9);
    EXPECT_NEAR(materials[i].shear_modulus, 1e9 + 2e9 * rocky, 1e-3);
  }
}
} // namespace asperity::fem
