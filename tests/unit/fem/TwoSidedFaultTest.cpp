#include "fem/BodyMatrices.hpp"
#include "fem/BoundaryCells.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/NodalDamping.hpp"
#include "fem/motions/RigidBodyMotions.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

// Faults inside the body: what the unknowns at their nodes, mean and jump, mean.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
constexpr double off = 1e-9;

// [0, 3] x [0, 2] with a fault along y = 1 for x between the two ends, turned about the origin.
GlobalMesh<2> cut(double from, double to, double angle = 0)
{
  auto mesh = uniformRectangle(6, 4, 3, 2);
  mesh::addFaults<2>(mesh, {{"fault", [=](Point<2> const& x) {
                               return std::abs(x[1] - 1) < off && x[0] > from - off &&
                                      x[0] < to + off;
                             }}});
  rotate(mesh, angle);
  mesh::splitFaults(mesh, "test");
  return mesh;
}

// The unit cube, cut through at z = 1/2.
GlobalMesh<3> cutCube()
{
  auto mesh = uniformCube(4);
  mesh::addFaults<3>(mesh,
                     {{"fault", [](Point<3> const& x) { return std::abs(x[2] - 0.5) < off; }}});
  mesh::splitFaults(mesh, "test");
  return mesh;
}

template <int Dim>
std::vector<VelocityCondition<Dim>> contact()
{
  return {{"Fault", "fault", ContactAcrossFault{{"fault"}}}};
}

template <int Dim>
std::vector<Material> twoMaterials(Mesh<Dim> const& mesh)
{
  std::vector<Material> materials;
  for (auto const& cell : mesh.cells) {
    double height = 0;
    for (int vertex : cell) {
      height += mesh.vertices[vertex][Dim - 1] / (Dim + 1);
    }
    materials.push_back(height > (Dim == 2 ? 1. : 0.5) ? Material{900, 5e4, 2e4, 10, 5}
                                                       : Material{2700, 7e4, 4e4, 30, 20});
  }
  return materials;
}

// A vector at the vertices, another one on every side, the same on every rank.
template <int Dim>
Point<3> valueAt(Mesh<Dim> const& mesh, int vertex)
{
  return {pseudorandom(mesh.global_ids[vertex], 0), pseudorandom(mesh.global_ids[vertex], 1),
          pseudorandom(mesh.global_ids[vertex], 2)};
}

// What the nodes carry so that the vertices have these vectors.
template <int Dim, class Value>
RCP<Vector> unknowns(Constrained<Dim> const& body, Value const& value)
{
  std::vector<double> along_axes;
  for (int vertex = 0; vertex < body.mesh.num_owned; ++vertex) {
    auto const vector = value(vertex);
    along_axes.insert(along_axes.end(), vector.begin(), vector.begin() + Dim);
  }
  auto const unknowns = unknownsOf(body.constraints.frames(), along_axes);
  return rcp(new Vector(body.dofs.owned(), Teuchos::arrayViewFromVector(unknowns)));
}

double quadraticForm(CrsMatrix const& A, Vector const& x)
{
  Vector y(A.getRangeMap());
  A.apply(x, y);
  return x.dot(y);
}

// Twice the energies of an unsplit mesh whose vertices are those of the split one.
template <int Dim>
void expectEnergiesOfTwoBodies(GlobalMesh<Dim> const& whole)
{
  const Constrained<Dim> body(whole, contact<Dim>());
  auto two_bodies = whole;
  two_bodies.splits.clear();
  two_bodies.faults.clear();
  two_bodies.boundaries.clear();
  const Constrained<Dim> apart(two_bodies, {});
  auto const matrices =
    assembleBody<Dim>(body.mesh, body.dofs, body.constraints.frames(), twoMaterials(body.mesh));
  auto const reference =
    assembleBody<Dim>(apart.mesh, apart.dofs, apart.constraints.frames(), twoMaterials(apart.mesh));
  const auto x = unknowns(body, [&](int vertex) { return valueAt(body.mesh, vertex); });
  const auto y = unknowns(apart, [&](int vertex) { return valueAt(apart.mesh, vertex); });
  const auto expectSame = [&](CrsMatrix const& A, CrsMatrix const& B) {
    const double expected = quadraticForm(B, *y);
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(quadraticForm(A, *x), expected, 1e-12 * expected);
  };
  expectSame(*matrices.mass, *reference.mass);
  expectSame(*matrices.viscosity, *reference.viscosity);
  expectSame(*matrices.stiffness, *reference.stiffness);
}
} // namespace

TEST(TwoSidedFault, HasTheEnergiesOfTwoBodies)
{
  expectEnergiesOfTwoBodies(cut(0, 3));
  expectEnergiesOfTwoBodies(cut(0, 3, 0.4));
  expectEnergiesOfTwoBodies(cutCube());
}

TEST(TwoSidedFault, GivesBackTheVectorsAtItsVertices)
{
  const Constrained<2> body(cut(1, 3, 0.4), contact<2>());
  const auto value = [&](int vertex) {
    auto result = valueAt(body.mesh, vertex);
    for (auto const& split : body.mesh.splits) { // nothing jumps at a tip
      result = split.is_tip && vertex == split.plus ? valueAt(body.mesh, split.minus) : result;
    }
    return result;
  };
  auto const vectors = alongAxes(body.constraints.frames(), body.dofs, *unknowns(body, value));
  for (int vertex = 0; vertex < body.mesh.num_owned; ++vertex) {
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(vectors[2 * vertex + d], value(vertex)[d], 1e-15);
    }
  }
  std::vector<int> backwards(body.mesh.num_owned);
  std::iota(backwards.rbegin(), backwards.rend(), 0);
  auto const chosen =
    alongAxes(body.constraints.frames(), body.dofs, *unknowns(body, value), backwards);
  for (std::size_t i = 0; i < backwards.size(); ++i) {
    for (int d = 0; d < 2; ++d) {
      EXPECT_EQ(chosen[2 * i + d], vectors[2 * backwards[i] + d]);
    }
  }
}

TEST(TwoSidedFault, DoesNotOpenAndEndsAtItsTip)
{
  const double angle = 0.4;
  const Constrained<2> body(cut(1, 3, angle), contact<2>());
  int num_pairs = 0;
  for (auto const& split : body.mesh.splits) {
    if (split.plus >= body.mesh.num_owned) {
      continue;
    }
    ++num_pairs;
    EXPECT_EQ(body.fixed(split.plus, 0), split.is_tip) << "along the fault";
    EXPECT_TRUE(body.fixed(split.plus, 1)) << "across it";
    EXPECT_NEAR(
      std::abs(body.row(split.plus, 1).dot(Eigen::Vector2d(-std::sin(angle), std::cos(angle)))), 1,
      1e-14);
    EXPECT_FALSE(body.fixed(split.minus, 0) || body.fixed(split.minus, 1)) << "the mean is free";
  }
  EXPECT_EQ(sumOverRanks(num_pairs), 5);
}

// K has no energy for motions of one side along the fault against the other, and for rigid ones.
TEST(TwoSidedFault, SlidesWithoutForce)
{
  const Constrained<2> body(cut(0, 3), contact<2>());
  auto const matrices =
    assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(), twoMaterials(body.mesh));
  const auto x = unknowns(body, [&](int vertex) {
    bool above = body.mesh.vertices[vertex][1] > 1 + off;
    for (auto const& split : body.mesh.splits) {
      above = above || vertex == split.plus;
    }
    return above ? Point<3>{1, 0, 0} : Point<3>{-2, 0, 0};
  });
  EXPECT_NEAR(quadraticForm(*matrices.stiffness, *x), 0, 1e-9);
  auto const rigid = rigidBodyMotions(body.mesh, body.dofs, body.constraints.frames());
  MultiVector forces(matrices.stiffness->getRangeMap(), rigid->getNumVectors());
  matrices.stiffness->apply(*rigid, forces);
  for (std::size_t k = 0; k < rigid->getNumVectors(); ++k) {
    EXPECT_LT(forces.getVector(k)->normInf(), 1e-9);
    EXPECT_GT(rigid->getVector(k)->norm2(), 1);
  }
}

TEST(TwoSidedFault, TakesConditionsInPairs)
{
  // The right side of each body moves up or down; the fault slips by the difference.
  const auto up = [](double size) {
    return PrescribedVelocity<2>{{0, 1}, [size](Point<2> const&, double t) { return size * t; }};
  };
  auto mesh = uniformRectangle(6, 4, 3, 2);
  mesh::addFaults<2>(mesh,
                     {{"fault", [](Point<2> const& x) { return std::abs(x[0] - 1.5) < off; }}});
  auto& bottom = mesh.boundaries["bottom"];
  for (auto const& facet : bottom) {
    const bool right = mesh.vertices[facet[0]][0] + mesh.vertices[facet[1]][0] > 3;
    mesh.boundaries[right ? "bottom right" : "bottom left"].push_back(facet);
  }
  mesh.boundaries.erase("bottom");
  mesh::splitFaults(mesh, "test");
  auto conditions = contact<2>();
  conditions.push_back({"Left", "bottom left", up(-1)});
  conditions.push_back({"Right", "bottom right", up(3)});
  const Constrained<2> body(mesh, conditions);
  for (auto const& split : body.mesh.splits) {
    if (split.plus < body.mesh.num_owned && body.mesh.vertices[split.plus][1] < off) {
      EXPECT_NEAR(body.velocity(split.plus, 2)[1], 8, 1e-14) << "v+ - v-";
      EXPECT_NEAR(body.velocity(split.minus, 2)[1], 2, 1e-14) << "their mean";
      EXPECT_NEAR(body.velocity(split.plus, 2)[0], 0, 1e-14);
    }
  }

  conditions.pop_back();
  asperity::test::expectRefusal([&] { Constrained<2>(mesh, conditions); },
                                {"Left", "one side of a fault alone", "x = (1.5, 0)"});
}

TEST(TwoSidedFault, HasOneSurfaceWithTwoCopiesOfEachNode)
{
  const Constrained<2> body(cut(1, 3), contact<2>());
  auto const materials = twoMaterials(body.mesh);
  auto const matrices = assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(), materials);
  auto const surface = makeFaultSurface(body.mesh, "fault", body.constraints, body.dofs,
                                        *matrices.stiffness->getCrsGraph(), OtherSide::body);
  EXPECT_EQ(surface->numGlobalNodes(), 5);
  EXPECT_NEAR(surface->totalWeight(), 2, 1e-14);
  EXPECT_EQ(surface->slipFactor(), 1);
  auto const beside = materialsAtNodes(body.mesh, *surface, materials);
  for (int node = 0; node < surface->numNodes(); ++node) {
    EXPECT_EQ((*surface)[node].copies.size(), 2u);
    EXPECT_EQ(surface->slides(node), (*surface)[node].place[0] > 1 + off) << "not at the tip";
    EXPECT_NEAR((*surface)[node].normal[1], -1, 1e-14) << "out of the upper side";
    EXPECT_NEAR(beside[node].shear_modulus, 2 / (1 / 2e4 + 1 / 4e4), 1e-9);
    const double upper = std::sqrt(900 * 2e4), lower = std::sqrt(2700 * 4e4);
    EXPECT_NEAR(beside[node].shearImpedance(), 2 / (1 / upper + 1 / lower), 1e-9);
  }
}

// The unknown across a fault that may open is the opening, up to its sign, whichever way the fault
// lies; the frames, also those of tips, are those of a fault that may not.
template <int Dim>
void expectOpening(GlobalMesh<Dim> const& mesh)
{
  const Constrained<Dim> body(mesh, {{"Fault", "fault", FreeAcrossFault{{"fault"}}}});
  const Constrained<Dim> shut(mesh, contact<Dim>());
  auto const matrices =
    assembleBody<Dim>(body.mesh, body.dofs, body.constraints.frames(), twoMaterials(body.mesh));
  auto side = OtherSide::body;
  side.may_open = true;
  auto const surface = makeFaultSurface(body.mesh, "fault", body.constraints, body.dofs,
                                        *matrices.stiffness->getCrsGraph(), side);
  ASSERT_EQ(surface->numUnknowns(), Dim);
  std::set<int> tips;
  for (auto const& split : body.mesh.splits) {
    if (split.is_tip) {
      tips.insert(split.plus);
    }
  }
  for (int node = 0; node < surface->numNodes(); ++node) {
    auto const& of_node = (*surface)[node];
    const int plus = of_node.copies.front();
    EXPECT_EQ(surface->opens(node), tips.count(plus) == 0);
    for (int row = 0; row < Dim; ++row) {
      for (int c = 0; c < Dim; ++c) {
        EXPECT_EQ(body.constraints.frames().entry(plus, row, c),
                  shut.constraints.frames().entry(plus, row, c));
      }
    }
    // The plus side goes away from the minus side, where the normal points, and along the fault.
    const auto x = unknowns(body, [&](int vertex) -> Point<3> {
      Point<3> moved{};
      for (int c = 0; c < Dim && vertex == plus && tips.count(plus) == 0; ++c) {
        moved[c] = -2 * of_node.normal[c] + 5 * of_node.tangents[0][c];
      }
      return moved;
    });
    auto const values = x->getLocalViewHost(Tpetra::Access::ReadOnly);
    EXPECT_NEAR(of_node.opening_sign * values(of_node.across, 0), surface->opens(node) ? 2 : 0,
                1e-13);
    EXPECT_EQ(surface->unknownsOf(node).back(), of_node.across);
  }
}

TEST(TwoSidedFault, HasTheOpeningAsAnUnknown)
{
  expectOpening(cut(1, 3));
  expectOpening(cut(0, 3, 0.4));
  expectOpening(cut(1, 3, 2.5));
  expectOpening(cutCube());
}

// Dashpots on a boundary that a fault ends at take from each side what they would from a body that
// is not cut.
TEST(TwoSidedFault, LeavesDashpotsOnBothSides)
{
  const Constrained<2> body(cut(0, 3), contact<2>());
  auto const materials = twoMaterials(body.mesh);
  auto const matrices = assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(), materials);
  auto const zero = zeroLike(*matrices.mass);
  auto const damped = withDampers(
    *zero, body.dofs,
    resistanceOf<2>(body.mesh, absorbingBoundary("right"), body.constraints.frames(), materials));
  const auto x = unknowns(body, [&](int vertex) {
    bool above = body.mesh.vertices[vertex][1] > 1 + off;
    for (auto const& split : body.mesh.splits) {
      above = above || vertex == split.plus;
    }
    return above ? Point<3>{1, 2, 0} : Point<3>{0, 0, 0};
  });
  // One metre of boundary with the upper material: rho cp on the velocity across, rho cs along.
  const Material upper{900, 5e4, 2e4, 10, 5};
  EXPECT_NEAR(quadraticForm(*damped, *x),
              upper.compressionalImpedance() + 4 * upper.shearImpedance(), 1e-8);
}
} // namespace asperity::fem
