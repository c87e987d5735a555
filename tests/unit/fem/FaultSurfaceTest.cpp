#include "fem/FaultSurface.hpp"

#include "fem/BodyMatrices.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "fem/SupportWeights.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/parallel/Partition.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

#include <set>

namespace asperity::fem
{
using namespace fem::test;

namespace
{
std::vector<Material> materialsOf(std::size_t num_cells)
{
  return std::vector<Material>(num_cells, Material{900, 5e4, 2e4, 1e3, 1e3});
}

// The bottom of a rectangle in bilateral contact, between its two ends, which are held as well.
std::shared_ptr<const FaultSurface> bottomOf(Constrained<2> const& body, OtherSide side)
{
  auto const matrices = assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(),
                                        materialsOf(body.mesh.cells.size()));
  return makeFaultSurface(body.mesh, "bottom", body.constraints, body.dofs,
                          *matrices.stiffness->getCrsGraph(), side);
}

std::vector<Condition> contactBetweenEnds()
{
  return {{"Fault", "bottom", SlidingWall{}},
          {"Left", "left", AtRestAlong{{1, 0}}},
          {"Right", "right", AtRestAlong{{1, 0}}}};
}
} // namespace

TEST(FaultSurface, IsMadeOfTheNodesOfItsBoundary)
{
  for (double angle : {0., 0.3}) {
    const Constrained<2> body(rectangle(angle), {Condition{"Fault", "bottom", SlidingWall{}}});
    auto const surface = bottomOf(body, OtherSide::rigid_foundation);
    auto const measure = boundaryMeasure(body.mesh, "bottom", *worldCommunicator());
    ASSERT_EQ(surface->numNodes(), static_cast<int>(measure.size()));
    EXPECT_EQ(surface->numGlobalNodes(), 7);
    EXPECT_NEAR(surface->totalWeight(), 3, 1e-14);
    EXPECT_EQ(surface->numTangents(), 1);
    auto const weights = toHost(surface->weights());
    auto const dofs = toHost(surface->dofs());
    for (int i = 0; i < surface->numNodes(); ++i) {
      auto const& node = (*surface)[i];
      EXPECT_EQ(surface->vertex(i), measure[i].node);
      EXPECT_EQ(node.copies, std::vector<int>{measure[i].node}) << "one: it is a boundary";
      EXPECT_EQ(weights(i), measure[i].weight);
      EXPECT_EQ(node.place[0], body.mesh.vertices[measure[i].node][0]);
      EXPECT_EQ(node.normal[1], measure[i].normal[1]);
      EXPECT_EQ(dofs(i, 0), body.dofs.dof(measure[i].node, 0)) << "along the boundary";
      EXPECT_NEAR(node.tangents[0][0], -node.normal[1], 1e-14);
      EXPECT_NEAR(node.tangents[0][1], node.normal[0], 1e-14);
      EXPECT_TRUE(surface->slides(i));
    }
  }
}

TEST(FaultSurface, KnowsWhatIsHeld)
{
  const Constrained<2> body(rectangle(), contactBetweenEnds());
  auto const surface = bottomOf(body, OtherSide::rigid_foundation);
  auto const held = toHost(surface->heldDofs());
  int num_held = 0;
  for (int i = 0; i < surface->numNodes(); ++i) {
    auto const x = body.mesh.vertices[surface->vertex(i)][0];
    EXPECT_EQ(surface->held(i, 0), x == 0 || x == 3);
    EXPECT_EQ(surface->slides(i), !surface->held(i, 0));
    EXPECT_EQ(held((*surface)[i].dofs[0]), surface->held(i, 0) ? 1 : 0);
    num_held += surface->held(i, 0);
  }
  EXPECT_EQ(sumOverRanks(num_held), 2);
}

TEST(FaultSurface, ColoursTheNodesThatSlide)
{
  const Constrained<2> body(rectangle(), contactBetweenEnds());
  auto const surface = bottomOf(body, OtherSide::rigid_foundation);
  std::set<int> seen;
  for (auto const& colour : surface->colours()) {
    auto const nodes = toHost(colour);
    for (std::size_t k = 0; k < nodes.extent(0); ++k) {
      EXPECT_TRUE(surface->slides(nodes(k)));
      EXPECT_TRUE(seen.insert(nodes(k)).second) << "once";
    }
  }
  EXPECT_EQ(sumOverRanks(static_cast<int>(seen.size())), 5);
  EXPECT_GE(surface->colours().size(), 2u) << "neighbours differ";
}

TEST(FaultSurface, MapsUnknownsToSlip)
{
  const Constrained<2> body(rectangle(), {Condition{"Fault", "bottom", SlidingWall{}}});
  EXPECT_EQ(bottomOf(body, OtherSide::rigid_foundation)->slipFactor(), 1);
  auto const mirror = bottomOf(body, OtherSide::mirror_image);
  EXPECT_EQ(mirror->slipFactor(), 2);
  auto const factors = toHost(mirror->slipFactors());
  for (int i = 0; i < mirror->numNodes(); ++i) {
    EXPECT_EQ(factors(i), 2);
  }
}

namespace
{
// The bottom of a box of which all nodes slide, or none.
FaultSurface bottomOfBox(Mesh<3> const& mesh, bool slides)
{
  std::vector<FaultNode> nodes;
  for (auto const& measure : boundaryMeasure(mesh, "bottom", *worldCommunicator())) {
    FaultNode node;
    node.copies = {measure.node};
    node.weight = measure.weight;
    node.normal = measure.normal;
    node.dofs = {3 * measure.node, 3 * measure.node + 1};
    nodes.push_back(node);
  }
  const int num_dofs = 3 * static_cast<int>(mesh.vertices.size());
  const HeldDofs held(std::vector<int>(num_dofs, slides ? 0 : 1), 3 * mesh.num_owned);
  return {"bottom", nodes, 2, held, {}, OtherSide::rigid_foundation, worldCommunicator()};
}
} // namespace

TEST(SupportWeights, RefuseAWallThatIsObliqueToTheFault)
{
  if (!oneRank()) {
    GTEST_SKIP() << "only the rank that owns the edge refuses";
  }
  for (double slope : {0., 0.5}) {
    auto whole = mesh::boxMesh({{2, 1, 1}, {2, 1, 1}, {}});
    for (auto& vertex : whole.vertices) {
      vertex[0] += slope * vertex[1];
    }
    auto const mesh = mesh::distribute(whole, *worldCommunicator());
    const std::vector<VelocityCondition<3>> walls = {{"Wall", "left", SlidingWall{}}};
    std::vector<double> shares;
    for (auto const& node : bottomOfBox(mesh, false)) {
      shares.push_back(node.weight);
    }
    auto const weights = [&](bool slides) {
      return supportWeights(mesh, bottomOfBox(mesh, slides), walls);
    };
    EXPECT_EQ(weights(false), shares);
    if (slope == 0) {
      EXPECT_EQ(weights(true), shares);
    } else {
      asperity::test::expectRefusal([&] { weights(true); },
                                    {"Friction / Normal Stress", "Wall", "x = (0, 0, "});
    }
  }
}
} // namespace asperity::fem
