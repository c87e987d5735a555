#include "fem/BodyMatrices.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

// A branch that ends with a joint at a fault in the plane of the mesh, as in antiplane models.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
constexpr double off = 1e-9;
constexpr double wide = 1.5; // width of cells with x > 1.5, over that of the others
constexpr double share_of_wide = wide / (1 + wide);

// [0, 3.75] x [0, 2] with the fault `main` along y = 1 and `branch` above it along x = 1.5.
GlobalMesh<2> branchedRectangle()
{
  auto mesh = uniformRectangle(6, 4, 3, 2);
  mesh::addFaults<2>(
    mesh, {{"branch", [](auto& x) { return std::abs(x[0] - 1.5) < off && x[1] > 1 - off; }},
           {"main", [](auto& x) { return std::abs(x[1] - 1) < off; }}});
  for (auto& x : mesh.vertices) {
    x[0] += x[0] > 1.5 ? (wide - 1) * (x[0] - 1.5) : 0;
  }
  mesh::splitFaults(mesh, "test", mesh::BranchEnd::joint);
  return mesh;
}
} // namespace

// Out of the plane three blocks may move each on its own: no dof is held, and none has a force.
TEST(JointsInThePlane, SlipInAntiplaneMotion)
{
  const auto whole = branchedRectangle();
  const Constrained<2> body(whole, {}, 1);
  auto const matrices =
    assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(),
                    std::vector<Material>(body.mesh.cells.size(), {900, 5e4, 2e4, 10, 5}));
  std::vector<double> of_blocks(body.mesh.vertices.size(), 0.);
  for (auto const& cell : body.mesh.cells) {
    const auto x = mesh::centroid(mesh::corners<2>(body.mesh.vertices, cell));
    for (int vertex : cell) {
      of_blocks[vertex] = x[1] < 1 ? 1. : x[0] < 1.5 ? -2. : 4.;
    }
  }
  of_blocks.resize(body.mesh.num_owned);
  const auto values = unknownsOf(body.constraints.frames(), of_blocks);
  const Vector x(body.dofs.owned(), Teuchos::arrayViewFromVector(values));
  Vector force(body.dofs.owned());
  matrices.stiffness->apply(x, force);
  EXPECT_LT(force.normInf(), 1e-9);
  auto const& terms = body.constraints.frames().vertexTerms();
  int num_joints = 0;
  for (std::size_t i = 0; i < terms.joints().size(); ++i) {
    auto const& joint = terms.joints()[i];
    if (joint.plus >= body.mesh.num_owned) {
      continue;
    }
    ++num_joints;
    EXPECT_NEAR(terms.share(i), share_of_wide, 1e-12);
    EXPECT_FALSE(body.fixed(joint.plus, 0) || body.fixed(joint.main, 0));
    EXPECT_NEAR(values[joint.plus], 6, 1e-14);
    EXPECT_NEAR(values[joint.main], share_of_wide * 4 + (1 - share_of_wide) * -2 - 1, 1e-14);
  }
  EXPECT_EQ(sumOverRanks(num_joints), 1);
}

TEST(JointsInThePlane, TakeAGivenSlipInAntiplaneMotion)
{
  const auto rate = [](auto const&, double) { return 2.; };
  const Constrained<2> body(branchedRectangle(),
                            {{"Rate", "branch", PrescribedVelocity<2>{{1.}, rate}}}, 1);
  Vector v(body.dofs.owned());
  body.constraints.prescribedVelocity(0, v);
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (auto const& joint : body.constraints.frames().vertexTerms().joints()) {
    if (joint.plus < body.mesh.num_owned) {
      EXPECT_TRUE(body.fixed(joint.plus, 0));
      EXPECT_FALSE(body.fixed(joint.main, 0));
      EXPECT_EQ(values(body.dofs.dof(joint.plus, 0), 0), 2);
    }
  }
}

// In plane strain the jump over the branch is across one of the faults: all of it is held.
TEST(JointsInThePlane, AreHeldInPlaneStrain)
{
  const Constrained<2> body(branchedRectangle(),
                            {{"Branch", "branch", ContactAcrossFault{{"branch"}}},
                             {"Main", "main", ContactAcrossFault{{"main"}}}});
  for (auto const& joint : body.constraints.frames().vertexTerms().joints()) {
    EXPECT_TRUE(body.fixed(joint.plus, 0) && body.fixed(joint.plus, 1));
    EXPECT_EQ(body.fixed(joint.main, 0) + body.fixed(joint.main, 1), 1);
  }
}
} // namespace asperity::fem
