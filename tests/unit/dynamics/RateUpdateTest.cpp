#include "dynamics/RateUpdate.hpp"

#include "unit/dynamics/OneDof.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
const DofMotion start = {0.3, -1.7, 2.9, -0.6};
} // namespace

// Pipping 2014, table 3.1: the equations that define the schemes, for any v1.
TEST(RateUpdate, NewmarkSatisfiesItsEquations)
{
  OneDof dof;
  for (double beta : {0., 0.25, 0.3, 0.5}) {
    for (double tau : {1e-3, 0.7}) {
      auto const end = dof.step(RateUpdate::newmark(beta), start, tau, 4.2);
      EXPECT_NEAR(end.v, start.v + tau * (start.a + end.a) / 2, 1e-13);
      EXPECT_NEAR(end.u,
                  start.u + tau * start.v +
                    tau * tau / 2 * ((1 - 2 * beta) * start.a + 2 * beta * end.a),
                  1e-13);
    }
  }
}

TEST(RateUpdate, BackwardEulerSatisfiesItsEquations)
{
  OneDof dof;
  for (double tau : {1e-3, 0.7}) {
    auto const end = dof.step(RateUpdate::backwardEuler(), start, tau, 4.2);
    EXPECT_NEAR(end.v, start.v + tau * end.a, 1e-13);
    EXPECT_NEAR(end.u, start.u + tau * end.v, 1e-13);
  }
}

// Newmark's formulas with the scheme's own acceleration A, which lags behind a by -alpha_m steps,
// and a1 the mean that balances momentum.
TEST(RateUpdate, GeneralisedAlphaSatisfiesItsEquations)
{
  OneDof dof;
  for (double rho : {0., 0.5, 0.8, 1.}) {
    const double alpha_m = (rho - 1) / (rho + 1);
    const double gamma = 0.5 - alpha_m;
    const double beta = std::pow(1 - alpha_m, 2) / 4;
    for (double tau : {1e-3, 0.7}) {
      auto const end = dof.step(RateUpdate::generalisedAlpha(rho), start, tau, 4.2);
      const double A0 = start.a + alpha_m * tau * start.jerk;
      const double A1 = end.a + alpha_m * tau * end.jerk;
      EXPECT_NEAR(end.v, start.v + tau * ((1 - gamma) * A0 + gamma * A1), 1e-12);
      EXPECT_NEAR(end.u, start.u + tau * start.v + tau * tau * ((0.5 - beta) * A0 + beta * A1),
                  1e-12);
      EXPECT_NEAR(end.a, (1 - alpha_m) * A1 + alpha_m * A0, 1e-13 * std::abs(end.a));
    }
  }
}

TEST(RateUpdate, GeneralisedAlphaWithoutDampingIsNewmark)
{
  OneDof dof;
  for (double tau : {1e-3, 0.7}) {
    auto const newmark = dof.step(RateUpdate::newmark(0.25), start, tau, 4.2);
    auto const end = dof.step(RateUpdate::generalisedAlpha(1), start, tau, 4.2);
    EXPECT_DOUBLE_EQ(end.u, newmark.u);
    EXPECT_DOUBLE_EQ(end.a, newmark.a);
  }
}

// From rest a^ is nothing but d_a A0.
TEST(RateUpdate, LaggingAccelerationIsThatOfTheStepToCome)
{
  const RCP<const Map> map = rcp(new Map(1, 0, fem::test::selfCommunicator()));
  State state;
  for (auto* x : {&state.u, &state.v, &state.a, &state.jerk}) {
    *x = rcp(new Vector(map));
  }
  state.a->putScalar(5);
  state.jerk->putScalar(30);
  Vector u_hat(map), a_hat(map);
  const auto A0 = [&](RateUpdate const& update, double tau) {
    update.predict(state, tau, u_hat, a_hat);
    return a_hat.getData()[0] / update.acceleration_in_acceleration;
  };
  for (double tau : {0.1, 0.2}) {
    EXPECT_DOUBLE_EQ(A0(RateUpdate::generalisedAlpha(0), tau), 5 - 30 * tau);
    EXPECT_DOUBLE_EQ(A0(RateUpdate::generalisedAlpha(0.5), tau), 5 - 10 * tau);
    EXPECT_EQ(A0(RateUpdate::newmark(0.25), tau), 5);
  }
}

// The motion of an oscillator is known from any point on, so that the error of each step is. Steps
// are 1/40 of a radian: terms of the next order are some 5 % of what velocity_error says.
TEST(RateUpdate, KnowsTheErrorOfItsVelocity)
{
  OneDof dof;
  const double tau = 1. / 40;
  for (auto const& update :
       {RateUpdate::backwardEuler(), RateUpdate::generalisedAlpha(0),
        RateUpdate::generalisedAlpha(0.5), RateUpdate::generalisedAlpha(0.9)}) {
    DofMotion motion = {1, 0, -1, 0};
    for (int n = 1; n <= 400; ++n) {
      auto const next = dof.step(update, motion, tau, Oscillator{1, 0, 1});
      const double error = next.v - (motion.v * std::cos(tau) - motion.u * std::sin(tau));
      const double growth = update.order == 1 ? next.a - motion.a : next.jerk - motion.jerk;
      const double scale = update.velocity_error * std::pow(tau, update.order + 1);
      if (n > 200) { // what the start has left has decayed
        EXPECT_NEAR(error, scale * growth / tau, 0.1 * scale) << update.name << ' ' << n;
      }
      motion = next;
    }
  }
  EXPECT_EQ(RateUpdate::newmark(0.25).velocity_error, 0);
  EXPECT_EQ(RateUpdate::generalisedAlpha(1).velocity_error, 0);
}

// What the update of the displacement says, and where that has lost its digits.
TEST(RateUpdate, MeanVelocityIsThatOfTheDisplacement)
{
  const RCP<const Map> map = rcp(new Map(2, 0, fem::test::selfCommunicator()));
  State from, to;
  for (auto* state : {&from, &to}) {
    for (auto* x : {&state->u, &state->v, &state->a, &state->jerk}) {
      *x = rcp(new Vector(map));
    }
  }
  from.v->putScalar(2);
  from.a->putScalar(-3);
  from.jerk->putScalar(7);
  to.v->putScalar(1.5);
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> second("second", 1, 1);
  Kokkos::deep_copy(second, 1);
  const double tau = 0.25;
  for (auto const& update : {RateUpdate::newmark(0.25), RateUpdate::backwardEuler(),
                             RateUpdate::generalisedAlpha(0.5)}) {
    Vector u_hat(map), a_hat(map), mean(map);
    update.predict(from, tau, u_hat, a_hat);
    update.complete(from, u_hat, a_hat, tau, to);
    update.meanVelocity(from, tau, *to.v, second, mean);
    Vector u(map), a(map);
    update.withVelocity(*to.v, u_hat, a_hat, tau, u, a);
    EXPECT_EQ(u.getData()[1], to.u->getData()[1]);
    EXPECT_EQ(a.getData()[1], to.a->getData()[1]);
    EXPECT_NEAR(mean.getData()[1], (to.u->getData()[1] - from.u->getData()[1]) / tau, 1e-14);
    EXPECT_EQ(mean.getData()[0], 0) << "not asked for";
  }
}

TEST(RateUpdate, SecondOrderFollowsConstantAccelerationExactly)
{
  OneDof dof;
  for (auto const& update : {RateUpdate::newmark(0.25), RateUpdate::generalisedAlpha(0.5),
                             RateUpdate::generalisedAlpha(0)}) {
    DofMotion motion = {0, 1, -3, 0};
    double t = 0;
    for (double tau : {0.1, 0.025, 0.2, 0.1}) {
      t += tau;
      motion = dof.step(update, motion, tau, 1 - 3 * t);
      EXPECT_NEAR(motion.u, t - 1.5 * t * t, 1e-14) << update.name;
      EXPECT_NEAR(motion.a, -3, 1e-12) << update.name;
      EXPECT_NEAR(motion.jerk, 0, 1e-10) << update.name;
    }
  }
}

// The weights of Z = (lambda_M / tau) M + C + (tau / lambda_K) K are the derivatives by v1.
TEST(RateUpdate, WeightsAreTheDerivativesByTheNewVelocity)
{
  OneDof dof;
  const double tau = 0.4;
  for (auto const& update :
       {RateUpdate::newmark(0.25), RateUpdate::newmark(0.4), RateUpdate::backwardEuler(),
        RateUpdate::generalisedAlpha(0), RateUpdate::generalisedAlpha(0.6)}) {
    auto const low = dof.step(update, start, tau, 1.);
    auto const high = dof.step(update, start, tau, 3.);
    EXPECT_NEAR((high.a - low.a) / 2, update.mass_weight / tau, 1e-13) << update.name;
    EXPECT_NEAR((high.u - low.u) / 2, update.stiffness_weight * tau, 1e-13) << update.name;
  }
}

TEST(RateUpdate, AllowsContactWithoutAccelerationsOfThePastOrByTheTrapezoidalRule)
{
  for (auto const& update :
       {RateUpdate::newmark(0.25), RateUpdate::backwardEuler(), RateUpdate::generalisedAlpha(1)}) {
    EXPECT_TRUE(update.allowsContact()) << update.name;
  }
  for (auto const& update : {RateUpdate::newmark(0.3), RateUpdate::generalisedAlpha(0.5)}) {
    EXPECT_FALSE(update.allowsContact()) << update.name;
  }
}
} // namespace asperity::dynamics
