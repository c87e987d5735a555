#include "dynamics/fault/NormalReaction.hpp"

#include "fem/SupportWeights.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
template <int Dim>
NormalReaction reactionOf(ModelIn<Dim> const& model)
{
  return {model.body, *model.surface, model.constraints->frames(),
          fem::supportWeights(model.mesh, *model.surface, model.options.conditions)};
}

// A vector without velocities at held dofs.
template <int Dim>
RCP<Vector> someMotion(ModelIn<Dim> const& model)
{
  auto w = model.body.vector();
  {
    auto const values = w->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int dof = 0; dof < model.body.numOwnedDofs(); ++dof) {
      values(dof, 0) = fem::test::pseudorandom(dof, 1);
    }
  }
  model.body.clearHeld(*w);
  return w;
}

// Compressed by eps along -y before it is turned, and free to widen.
template <int Dim>
void expectUniformCompression(ModelIn<Dim> const& model,
                              std::function<Point<Dim>(Point<Dim> const&)> const& displacement,
                              double sigma)
{
  auto const u = model.body.vector();
  auto const none = model.body.vector();
  model.setFree(*u, displacement);
  const NodeView R("R", model.surface->numNodes());
  reactionOf(model).compression(*none, {*u, *none, *none, {}}, R);
  ASSERT_GT(model.surface->numNodes(), 0);
  for (int i = 0; i < model.surface->numNodes(); ++i) {
    EXPECT_NEAR(R(i), sigma, 1e-10 * sigma) << i;
  }
}
} // namespace

// By hand: sigma_xx = 0 and plane strain give sigma = 4 G (3 K + G) / (3 K + 4 G) eps.
TEST(NormalReaction, IsTheStressOfABlockPressedOnADippingFoundation)
{
  for (double dip : {0., 0.6, -2.5}) {
    ModelOptions options;
    options.mesh = fem::test::uniformRectangle(5, 4, 0.5, 0.3);
    fem::test::rotate(options.mesh, dip);
    const Model model(options, fem::test::selfCommunicator());
    const double eps = 1e-4;
    const double K = options.material.bulk_modulus;
    const double G = options.material.shear_modulus;
    const double widening = (K - 2 * G / 3) / (K + 4 * G / 3) * eps;
    auto const displacement = [&](Point<2> const& x) -> Point<2> {
      const double along = x[0] * std::cos(dip) + x[1] * std::sin(dip);
      const double across = -x[0] * std::sin(dip) + x[1] * std::cos(dip);
      const double u = widening * along;
      const double v = -eps * across;
      return {u * std::cos(dip) - v * std::sin(dip), u * std::sin(dip) + v * std::cos(dip)};
    };
    expectUniformCompression<2>(model, displacement, 4 * G * (3 * K + G) / (3 * K + 4 * G) * eps);
  }
}

// In space, sigma = E eps.
TEST(NormalReaction, IsTheStressOfASolidPressedOnADippingFoundation)
{
  auto const turn = fem::test::rotationAbout({1, 2, -1}, 0.7);
  OptionsIn<3> options;
  options.mesh = fem::test::uniformBox({3, 2, 2}, {0.4, 0.3, 0.2});
  fem::test::rotate(options.mesh, turn);
  const ModelIn<3> model(options, fem::test::selfCommunicator());
  const double eps = 1e-4;
  const double K = options.material.bulk_modulus;
  const double G = options.material.shear_modulus;
  const double nu = (3 * K - 2 * G) / (6 * K + 2 * G);
  expectUniformCompression<3>(
    model,
    [&](Point<3> const& x) {
      auto const p = rotatedBack(turn, x);
      return rotated(turn, {nu * eps * p[0], -eps * p[1], nu * eps * p[2]});
    },
    9 * K * G / (3 * K + G) * eps);
}

// What a load carries does not press.
TEST(NormalReaction, IsLessByTheLoadAtTheNode)
{
  ModelOptions options;
  options.mesh = fem::test::uniformRectangle(4, 3, 0.4, 0.3);
  const Model model(options, fem::test::selfCommunicator());
  auto const& node = (*model.surface)[2];
  auto const load = model.body.vector();
  auto const none = model.body.vector();
  std::array<double, 2> local{};
  model.constraints->frames().toFrame(model.surface->vertex(2), node.normal.data(), local.data());
  for (int c = 0; c < 2; ++c) {
    load->replaceLocalValue(model.dofs->dof(model.surface->vertex(2), c), 3 * local[c]);
  }
  const NodeView R("R", model.surface->numNodes());
  reactionOf(model).compression(*load, {*none, *none, *none, {}}, R);
  EXPECT_NEAR(R(2), 3 / node.weight, 1e-12 * 3 / node.weight); // the load pushes outwards
  EXPECT_EQ(R(1), 0);
}

TEST(NormalReaction, RowsAreThoseOfTheMatrices)
{
  const Model model(slidingBlock(2), fem::test::selfCommunicator());
  auto const reaction = reactionOf(model);
  auto const w = someMotion(model);
  auto const scaled = [&](double factor) {
    auto x = rcp(new Vector(*w, Teuchos::Copy));
    x->scale(factor);
    return x;
  };
  auto const none = model.body.vector();
  const NodeView expected("R", model.surface->numNodes());
  reaction.compression(*none, {*scaled(5), *scaled(3), *scaled(2), {}}, expected);
  auto const rows = reaction.rows({2, 3, 5});
  Vector r(rows->getRangeMap());
  rows->apply(*w, r);
  const NodeView R("R", model.surface->numNodes());
  auto const values = r.getData();
  reaction.compression(
    toDevice(std::vector<double>(values.begin(), values.end()), "asperity::dynamics::r"), R);
  for (int i = 0; i < model.surface->numNodes(); ++i) {
    EXPECT_NEAR(R(i), expected(i), 1e-10 * std::abs(expected(i))) << i;
  }
}

// Both solvers, after each iteration of TNNMG, give N of their minimiser; the condensed one does
// so without computing it.
TEST(NormalReaction, ComesFromTheSolverWithoutItsWholeVelocity)
{
  const Model model(slidingBlock(2), fem::test::selfCommunicator());
  auto const state = slidingState(model);
  for (auto correction : {Correction::direct, Correction::multigrid}) {
    auto const rows = reactionOf(model).rows({1e3, 1, 1e-3});
    auto const Z = fem::combine(model.matrices, {1e3, 1, 1e-3}, model.body.held);
    auto const solver =
      makeRateSolver(Z, model.body, *model.surface, tightSettings(correction), rows);
    for (double size : {1., -3.}) {
      auto const b = someMotion(model);
      b->scale(size);
      solver->begin(*b, *model.body.vector());
      for (int iteration = 0; iteration < 3; ++iteration) {
        solver->improve(FrictionProblem(model.fault.friction(), {state.alpha, state.sigma_n}));
        Vector w(model.dofs->owned());
        solver->velocity(w);
        Vector expected(rows->getRangeMap());
        rows->apply(w, expected);
        const NodeView r("r", model.surface->numNodes());
        solver->reactions(r);
        for (int i = 0; i < r.extent_int(0); ++i) {
          EXPECT_NEAR(r(i), expected.getData()[i], 1e-11 * expected.normInf());
        }
      }
    }
  }
}
} // namespace asperity::dynamics
