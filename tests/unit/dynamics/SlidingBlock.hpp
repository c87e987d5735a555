#pragma once

#include "dynamics/observables/EnergyBalance.hpp"
#include "unit/dynamics/SmallModel.hpp"
#include "unit/fem/SampleMeshes.hpp"

namespace asperity::dynamics::test
{
using fem::test::rotated;
using fem::test::rotatedBack;
using fem::test::Rotation;

constexpr double loading_rate = 1e-3; // m/s

// A block of gelatine, 0.4 m by 0.3 m, that slides on its base, pushed at its right side with a
// rate that grows, drawn along by a traction that friction can just bear.
inline ModelOptions slidingBlock(int components)
{
  ModelOptions options;
  options.components = components;
  options.mesh = fem::test::uniformRectangle(4, 3, 0.4, 0.3);
  options.gravity = {1.5, -9.81};
  options.traction = 1400;
  std::vector<double> direction(components, 0.);
  direction[0] = 1;
  auto const push = [](Point<2> const& x, double t) { return loading_rate * (1 + x[1] + 30 * t); };
  options.conditions = {{"Push", "right", fem::PrescribedVelocity<2>{direction, push}}};
  return options;
}

// Sliding at about the loading rate, slower to the left; the state varies along the fault.
inline State slidingState(Model const& model)
{
  auto state = model.restingState();
  model.setFree(*state.v, [](Point<2> const& x) -> std::array<double, 2> {
    return {loading_rate * (0.5 + x[0]), loading_rate * x[1]};
  });
  state.alpha = model.nodeView([](Point<2> const& x) { return -1 + std::sin(9 * x[0]); });
  Kokkos::deep_copy(state.alpha_of_rate, state.alpha);
  return state;
}

// A block in space, turned as a whole: it slides on a bent base in both directions along it, pushed
// at its right side and held by a wall at its left.
inline OptionsIn<3> slidingBlockInSpace(std::array<int, 3> const& cells, Rotation const& turn)
{
  OptionsIn<3> options;
  options.mesh = fem::test::uniformBox(cells, {0.4, 0.3, 0.2});
  fem::test::distort(options.mesh, 0.002);
  for (auto& x : options.mesh.vertices) {
    x[1] += (0.1 * x[0] + 0.2 * x[0] * x[0] + 0.3 * x[2] * x[2]) * (1 - x[1] / 0.3);
  }
  fem::test::rotate(options.mesh, turn);
  options.gravity = rotated(turn, {1.5, -9.81, 0.7});
  options.traction_along_axes = rotated(turn, {1450, 0, 700});
  options.cohesion = 20;
  auto const push = [turn](double factor) {
    return [turn, factor](Point<3> const& x, double t) {
      return factor * loading_rate * (1 + rotatedBack(turn, x)[1] + 30 * t);
    };
  };
  auto const along = [turn](Point<3> const& direction) {
    auto const d = rotated(turn, direction);
    return std::vector<double>(d.begin(), d.end());
  };
  using Prescribed = fem::PrescribedVelocity<3>;
  options.conditions = {{"Push", "right", Prescribed{along({1, 0, 0}), push(1)}},
                        {"Push Aside", "right", Prescribed{along({0, 0, 1}), push(0.4)}},
                        {"Wall", "left", fem::SlidingWall{}}};
  return options;
}

inline State slidingState(ModelIn<3> const& model, Rotation const& turn)
{
  auto state = model.restingState();
  model.setFree(*state.v, [turn](Point<3> const& turned) {
    auto const x = rotatedBack(turn, turned);
    return rotated(turn, {loading_rate * (0.5 + x[0]), loading_rate * x[1],
                          loading_rate * (0.3 + std::sin(8 * x[0] + 3 * x[2]))});
  });
  state.alpha = model.nodeView([turn](Point<3> const& turned) {
    auto const x = rotatedBack(turn, turned);
    return -1 + std::sin(9 * x[0]) + std::cos(11 * x[2]);
  });
  Kokkos::deep_copy(state.alpha_of_rate, state.alpha);
  return state;
}
// What the balance has after steps of many sizes from a state, from the end of the first step on.
// J must not rise in them.
template <int Dim>
Energy energyOfSteps(ModelIn<Dim> const& model, State state)
{
  const DyadicTime clock(4e-3, 4);
  Stepper stepper(model, RateUpdate::newmark(0.25), clock);
  EnergyBalance balance(model.body, model.fault, clock);
  balance.start(state);
  auto next = state.clone();
  EXPECT_TRUE(stepper.step.solve(state, 4, next, stepper.count).solved());
  balance.start(next); // in balance
  for (int level : {2, 2, 1, 4, 0, 0, 1, 2, 3}) {
    state = next;
    next = state.clone();
    EXPECT_TRUE(stepper.step.solve(state, level, next, stepper.count).solved());
    balance.advance(next);
  }
  EXPECT_EQ(stepper.count.energy_increases, 0);
  return balance.energy();
}
} // namespace asperity::dynamics::test
