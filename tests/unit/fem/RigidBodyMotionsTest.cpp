#include "fem/motions/RigidBodyMotions.hpp"

#include "fem/BodyMatrices.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

// Motions without stiffness, as many as a body has.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
template <int Dim>
void expectNoForce(GlobalMesh<Dim> const& whole,
                   std::vector<VelocityCondition<Dim>> const& conditions, int expected)
{
  const Constrained<Dim> body(whole, conditions);
  const std::vector<Material> materials(body.mesh.cells.size(), {900, 5e4, 2e4, 1e3, 1e3});
  auto const K =
    assembleBody<Dim>(body.mesh, body.dofs, body.constraints.frames(), materials).stiffness;
  auto const motions = rigidBodyMotions(body.mesh, body.dofs, body.constraints.frames());
  ASSERT_EQ(static_cast<int>(motions->getNumVectors()), expected);
  MultiVector force(K->getRangeMap(), expected);
  K->apply(*motions, force);
  Eigen::MatrixXd products(expected, expected);
  for (int i = 0; i < expected; ++i) {
    EXPECT_LE(force.getVector(i)->normInf(), 1e-12 * K->getFrobeniusNorm());
    EXPECT_NEAR(motions->getVector(i)->normInf(), 1, 0.5);
    for (int j = 0; j < expected; ++j) {
      products(i, j) = motions->getVector(i)->dot(*motions->getVector(j));
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products);
  EXPECT_GT(solver.eigenvalues()[0], 1e-3 * solver.eigenvalues()[expected - 1]) << "independent";
}
} // namespace

TEST(RigidBodyMotions, OfAPlane)
{
  expectNoForce<2>(rectangle(0.3), {Condition{"Fault", "bottom", SlidingWall{}}}, 3);
}

TEST(RigidBodyMotions, OfSpace)
{
  auto whole = uniformBox({3, 2, 2}, {3, 2, 1});
  rotate(whole, rotationAbout({1, 2, 3}, 0.7));
  for (auto& x : whole.vertices) {
    x[0] += 100; // far from the origin
  }
  expectNoForce<3>(whole, {VelocityCondition<3>{"Fault", "bottom", SlidingWall{}}}, 6);
}

TEST(RigidBodyMotions, OfAPeriodicBodyAreThoseThatItsCopiesFollow)
{
  auto whole = uniformBox({3, 2, 4}, {3, 2, 1});
  // Its back is its front.
  const int layer = 4 * 3;
  const int first_of_back = 4 * layer;
  for (auto& cell : whole.cells) {
    for (int& v : cell) {
      v -= v >= first_of_back ? first_of_back : 0;
    }
  }
  whole.boundaries.erase("front");
  whole.boundaries.erase("back");
  for (auto& entry : whole.boundaries) {
    for (auto& facet : entry.second) {
      for (int& v : facet) {
        v -= v >= first_of_back ? first_of_back : 0;
      }
    }
  }
  whole.vertices.resize(first_of_back);
  whole.period = {0, 0, 1};
  expectNoForce<3>(whole, {}, 4);
}

TEST(RigidBodyMotions, OfAntiplaneMotionAreOne)
{
  const Constrained<2> body(rectangle(), {}, 1);
  auto const motions = rigidBodyMotions(body.mesh, body.dofs, body.constraints.frames());
  ASSERT_EQ(motions->getNumVectors(), 1u);
  EXPECT_EQ(motions->getVector(0)->normInf(), 1);
  EXPECT_EQ(motions->getVector(0)->meanValue(), 1);
}
} // namespace asperity::fem
