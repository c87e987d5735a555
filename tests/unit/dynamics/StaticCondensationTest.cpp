#include "dynamics/condensation/StaticCondensation.hpp"

#include "dynamics/condensation/VertexMotion.hpp"
#include "dynamics/coupling/CoupledStep.hpp"
#include "unit/dynamics/QuasiDynamicModel.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
constexpr double top_velocity = 2e-4;

// A block on a foundation, driven at its top, without viscosity.
ModelOptions drivenBlock()
{
  ModelOptions options;
  options.mesh = fem::test::uniformRectangle(5, 4, 0.5, 0.3);
  options.material.shear_viscosity = 0;
  options.material.bulk_viscosity = 0;
  options.conditions = {
    {"Drive", "top",
     fem::PrescribedVelocity<2>{{1, 0}, [](auto const&, double) { return top_velocity; }}},
    {"Lid", "top", fem::AtRestAlong{{0, 1}}}};
  return options;
}

State stepped(dynamics::Model const& model, int num_steps)
{
  const DyadicTime clock(0.5, 0);
  CoupledStep step(
    model.body, model.fault,
    {RateUpdate::generalisedAlpha(0.5), clock, tightCoupling(), tightSettings(), 1u << 30});
  SolveCount count;
  auto state = model.initial.clone();
  for (int i = 0; i < num_steps; ++i) {
    auto next = state.clone();
    EXPECT_TRUE(step.solve(state, 0, next, count).solved());
    state = next;
  }
  return state;
}
} // namespace

// [E P]'K[E P] by dense algebra: S = K_FF - K_FI K_II^-1 K_IF, and the same for the driven top.
// What motion across the fault would do is left out, since there is none.
TEST(StaticCondensation, StiffnessIsThatOfTheBodyInEquilibrium)
{
  const dynamics::test::Model model(drivenBlock(), fem::test::selfCommunicator());
  auto const whole = quasiDynamic(model);
  auto const condensation = StaticCondensation::make(whole);
  ASSERT_TRUE(condensation);

  std::vector<int> fault;
  for (int node = 0; node < model.surface->numNodes(); ++node) {
    fault.push_back(model.dofs->dof(model.surface->vertex(node), 0));
    fault.push_back(model.dofs->dof(model.surface->vertex(node), 1));
  }
  std::vector<int> inside;
  std::vector<int> held;
  for (int dof = 0; dof < whole.body.numOwnedDofs(); ++dof) {
    if (std::find(fault.begin(), fault.end(), dof) == fault.end()) {
      (whole.body.held[dof] ? held : inside).push_back(dof);
    }
  }
  EXPECT_EQ(condensation->numEliminated(), static_cast<int>(inside.size() + held.size()));
  auto const K = denseOf(*whole.body.matrices.stiffness);
  auto const prescribed = whole.body.vector();
  whole.body.prescribed_velocity(0, *prescribed);
  Eigen::VectorXd d(held.size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    d[i] = denseOf(*prescribed)[held[i]];
  }
  const Eigen::MatrixXd inverse = K(inside, inside).inverse();
  const Eigen::MatrixXd S = K(fault, fault) - K(fault, inside) * inverse * K(inside, fault);
  const Eigen::VectorXd at_fault =
    (K(fault, held) - K(fault, inside) * inverse * K(inside, held)) * d;
  const double of_top = d.dot((K(held, held) - K(held, inside) * inverse * K(inside, held)) * d);

  auto const condensed = denseOf(*condensation->model().body.matrices.stiffness);
  const int size = static_cast<int>(fault.size());
  const double scale = S.lpNorm<Eigen::Infinity>();
  EXPECT_LE((condensed.col(size).head(size) - at_fault).norm(), 1e-12 * at_fault.norm());
  int num_moving = 0;
  for (int i = 0; i < size; ++i) {
    const bool moves = !whole.body.held[fault[i]];
    num_moving += moves ? 1 : 0;
    EXPECT_NEAR(condensed(size, i), moves ? at_fault[i] : 0, 1e-12 * at_fault.norm());
    for (int row = 0; row < size; ++row) {
      const double expected = moves || row == i ? S(row, i) : 0;
      EXPECT_NEAR(condensed(row, i), expected, 1e-12 * scale);
    }
  }
  EXPECT_EQ(num_moving, model.surface->numNodes());
  EXPECT_NEAR(condensed(size, size), of_top, 1e-12 * of_top);
}

TEST(StaticCondensation, RowsAreCountedWhereverTheirReceiversAre)
{
  const dynamics::test::Model model(drivenBlock(), fem::test::selfCommunicator());
  auto const whole = quasiDynamic(model);
  auto const condensation = StaticCondensation::make(whole);
  ASSERT_TRUE(condensation);
  RecoveryRows rows(*condensation);
  EXPECT_EQ(rows.size(), 0u);
  ASSERT_TRUE(rows.add({model.dofs->dof(model.surface->vertex(1), 0)})); // on the fault
  EXPECT_EQ(rows.size(), 1u);
  EXPECT_FALSE(rows.cost().are_refused);

  std::vector<int> all(whole.body.numOwnedDofs());
  std::iota(all.begin(), all.end(), 0);
  const bool has_room = all.size() * rows.length() < rows.cost().of_body;
  EXPECT_EQ(rows.add(all), has_room);
  EXPECT_EQ(rows.cost().are_refused, !has_room);
}

TEST(StaticCondensation, StepsAreThoseOfTheWholeBody)
{
  const dynamics::test::Model model(drivenBlock(), fem::test::selfCommunicator());
  auto const whole = quasiDynamic(model);
  auto const condensation = StaticCondensation::make(whole);
  ASSERT_TRUE(condensation);
  auto const expected = stepped(whole, 20);
  auto const found = stepped(condensation->model(), 20);
  auto const u = whole.body.vector();
  condensation->expand(*found.u, *u);
  auto const expected_u = denseOf(*expected.u);
  auto const expected_alpha = denseOf(expected.alpha);
  EXPECT_GT(expected_u.norm(), 0);
  EXPECT_LE((denseOf(*u) - expected_u).norm(), 1e-10 * expected_u.norm());
  EXPECT_LE((denseOf(found.alpha) - expected_alpha).norm(), 1e-10 * expected_alpha.norm());
}

// Each row gives one entry of expand(), which making rows does not change.
TEST(StaticCondensation, RowsOfRecoveryGiveTheMotionOfTheWholeBody)
{
  const dynamics::test::Model model(drivenBlock(), fem::test::selfCommunicator());
  auto const whole = quasiDynamic(model);
  auto const condensation = StaticCondensation::make(whole);
  ASSERT_TRUE(condensation);
  auto const x = condensation->model().body.vector();
  {
    auto const values = x->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < values.extent(0); ++i) {
      values(i, 0) = fem::test::pseudorandom(static_cast<GlobalOrdinal>(i), 3);
    }
  }
  auto const u = whole.body.vector();
  condensation->expand(*x, *u);
  auto const expected = denseOf(*u), condensed = denseOf(*x);
  for (int dof = 0; dof < whole.body.numOwnedDofs(); ++dof) {
    auto const row = condensation->recoveryRow(dof);
    ASSERT_EQ(static_cast<Eigen::Index>(row.size()), condensed.size());
    const Eigen::Map<const Eigen::VectorXd> as_vector(row.data(), condensed.size());
    EXPECT_NEAR(as_vector.dot(condensed), expected[dof], 1e-13 * expected.norm()) << dof;
  }
  condensation->expand(*x, *u);
  EXPECT_EQ(denseOf(*u), expected);
}

// A state of the whole body and its amplitudes give the condensed state back, field by field.
TEST(StaticCondensation, HasAnAmplitudeForEachFieldOfTheBody)
{
  const dynamics::test::Model model(drivenBlock(), fem::test::selfCommunicator());
  auto const whole = quasiDynamic(model);
  auto const condensation = StaticCondensation::make(whole);
  ASSERT_TRUE(condensation);
  auto const at_three = condensation->amplitudesAt(3);
  ASSERT_EQ(at_three.size(), whole.initial.numBodyFields());
  const State state = condensation->gather(whole.initial, at_three);
  EXPECT_EQ(condensation->amplitudes(state), at_three);
  EXPECT_EQ(state.u->getData()[state.u->getLocalLength() - 2], 3); // s, before a dof without use
  EXPECT_EQ(state.v->getData()[state.v->getLocalLength() - 2], 1);
  EXPECT_EQ(state.a->normInf(), 0);

  auto too_few = at_three;
  too_few.pop_back();
  EXPECT_THROW(condensation->gather(whole.initial, too_few), std::logic_error);
}

TEST(StaticCondensation, IsRefusedWhereTheBodyIsNotInEquilibrium)
{
  const dynamics::test::Model model(drivenBlock(), fem::test::selfCommunicator());
  auto const whole = quasiDynamic(model);
  EXPECT_TRUE(StaticCondensation::make(whole));

  auto with_mass = quasiDynamic(model);
  with_mass.body.matrices.is_massless = false;
  EXPECT_FALSE(StaticCondensation::make(with_mass));

  auto strained = quasiDynamic(model);
  strained.initial.u->putScalar(1e-6);
  EXPECT_FALSE(StaticCondensation::make(strained));

  auto viscous = drivenBlock();
  viscous.material.shear_viscosity = 1;
  const dynamics::test::Model viscous_model(viscous, fem::test::selfCommunicator());
  EXPECT_FALSE(StaticCondensation::make(quasiDynamic(viscous_model)));
}
} // namespace asperity::dynamics
