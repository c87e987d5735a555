#pragma once

#include "dynamics/observables/EnergyBalance.hpp"
#include "unit/dynamics/QuasiDynamicModel.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

namespace asperity::dynamics::test
{
// An antiplane layer on a base that does not slip, whose top moves.
struct ShearedLayer
{
  static constexpr double height = 0.3, width = 0.4; // m

  // drive(t): the velocity of the top [m/s].
  template <class Drive>
  static ModelOptions options(Drive const& drive)
  {
    ModelOptions options;
    options.components = 1;
    options.mesh = fem::test::uniformRectangle(4, 3, width, height);
    fem::test::distort(options.mesh, 0.02);
    options.material = {900, 0.05e6, 0.023e6, 0, 0};
    options.sigma_n = 1e9;
    auto const at = [drive](auto const&, double t) { return drive(t); };
    options.conditions = {{"Drive", "top", fem::PrescribedVelocity<2>{{1}, at}}};
    return options;
  }

  explicit ShearedLayer(ModelOptions const& options)
      : model(options, fem::test::selfCommunicator())
      , body(quasiDynamic(model))
      , step(body.body, body.fault,
             {RateUpdate::backwardEuler(), clock, tightCoupling(), tightSettings(), 1U << 30U})
      , balance(body.body, body.fault, clock)
      , state(body.initial.clone())
      , forces(body.body.noForces())
  {
    Tpetra::deep_copy(*state.u, *body.body.vector());
    balance.start(state);
  }

  // Makes a step. Returns the time after it [s].
  double advance(int level)
  {
    auto next = state.clone();
    EXPECT_TRUE(step.solve(state, level, next, count).solved());
    state = next;
    balance.advance(state);
    return clock.seconds(state.time);
  }

  double stressAtTop() // [Pa]
  {
    body.body.computeForces(state.motion(), forces);
    double pull = 0; // N/m
    for (int dof : body.body.held.owned()) {
      pull += denseOf(*forces.elastic)[dof];
    }
    return pull / width;
  }

  Model model;
  dynamics::Model body;
  DyadicTime clock = {4, 4};
  CoupledStep step;
  EnergyBalance balance;
  State state;
  SolveCount count;
  BodyForces forces;
};
} // namespace asperity::dynamics::test
