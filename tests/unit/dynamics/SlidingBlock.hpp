#pragma once

#include "unit/dynamics/SmallModel.hpp"
#include "unit/fem/SampleMeshes.hpp"

namespace asperity::dynamics::testing
{
constexpr double loading_rate = 1e-3; // m/s

// A block of gelatine, 0.4 m by 0.3 m, that slides on its base, pushed at its right side with a
// rate that grows, drawn along by a traction that friction can just bear.
inline ModelOptions slidingBlock(int components)
{
  ModelOptions options;
  options.components = components;
  options.mesh = fem::testing::uniformRectangle(4, 3, 0.4, 0.3);
  options.gravity = {1.5, -9.81};
  options.traction = 1400;
  std::vector<double> direction(components, 0.);
  direction[0] = 1;
  options.conditions = {{"Push", "right", direction, [](Point<2> const& x, double t) {
                           return loading_rate * (1 + x[1] + 30 * t);
                         }}};
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
} // namespace asperity::dynamics::testing
