#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

// Nodes whose velocity is prescribed in one component and free in the other.
namespace asperity::friction::test
{
namespace
{
// In component 1 the velocity is prescribed; component 0 is free, with this force.
struct Half
{
  ReferenceNode node;
  double prescribed, curvature, load, guess;

  // Of the free component: what friction bears there of its whole traction.
  Real force(Real w) const
  {
    const Real rate = std::hypot(w, Real(prescribed));
    return node.force(rate) * (w / rate);
  }

  // Bisection for log w in long double.
  Real bisected() const
  {
    Real low = std::log(1e-300L), high = std::log(std::abs(Real(load)) / curvature);
    for (int k = 0; k < 140; ++k) {
      const Real middle = (low + high) / 2, w = std::exp(middle);
      (curvature * w + force(w) > std::abs(Real(load)) ? high : low) = middle;
    }
    return std::copysign(std::exp(high), Real(load));
  }
};

std::vector<Half> variousHalves(std::string const& law)
{
  std::mt19937 generator(11);
  const auto magnitude = [&](double low, double high) {
    return std::pow(10, std::uniform_real_distribution<double>(low, high)(generator));
  };
  std::vector<Half> result;
  for (auto const& node : variousNodes(law)) {
    for (int k = 0; k < 20; ++k) {
      const double prescribed = (k % 2 == 0 ? 1 : -1) * magnitude(-14, 1);
      const double w = magnitude(-20, 2), rate = std::hypot(w, prescribed);
      const auto bears = static_cast<double>(node.force(rate)) * w / rate;
      const double curvature = (1e-3 + bears) / w * magnitude(-6, 6);
      result.push_back({node, prescribed, curvature,
                        (k % 3 == 0 ? -1 : 1) * (curvature * w + bears), magnitude(-20, 2)});
    }
  }
  return result;
}

struct Views
{
  explicit Views(std::vector<Half> const& halves)
  {
    std::vector<ReferenceNode> nodes;
    std::vector<Values> forces, given, guesses;
    Values curvatures;
    for (auto const& half : halves) {
      nodes.push_back(half.node);
      forces.push_back({half.load, 0});
      given.push_back({0, half.prescribed});
      guesses.push_back({half.guess, 0});
      curvatures.push_back(half.curvature);
    }
    fault = std::make_unique<Fault>(nodes);
    at = fault->at;
    at.prescribed = toDevice(given);
    r = toDevice(forces);
    v = toDevice(guesses);
    curvature = toDevice(curvatures);
  }

  std::unique_ptr<Fault> fault;
  StateAndStress at;
  BlockView r, v;
  NodeView curvature;
};
} // namespace

TEST(Prescribed, LeavesTheOtherComponentToFriction)
{
  for (auto const& law : both_laws) {
    const auto halves = variousHalves(law);
    const Views views(halves);
    const int num_nodes = static_cast<int>(halves.size());
    EXPECT_EQ(views.fault->kernels->minimise(allNodes(num_nodes), views.curvature, views.r,
                                             views.at, views.v),
              0);
    const auto v = toHost(views.v);
    for (int i = 0; i < num_nodes; ++i) {
      auto const& half = halves[i];
      const auto expected = static_cast<double>(half.bisected());
      // The rounding of mu may decide where friction nearly bears all of the force.
      const Real rounding = half.node.forceTolerance(std::hypot(v(i, 0), half.prescribed));
      const Real found = v(i, 0), step = 1e-6L * std::abs(found);
      const Real slope =
        half.curvature + (half.force(found + step) - half.force(found - step)) / (2 * step);
      EXPECT_NEAR(v(i, 0), expected,
                  static_cast<double>(1e-12L * std::abs(found) + 4 * rounding / slope))
        << law << ' ' << i;
      EXPECT_EQ(v(i, 1), 0) << "the unknown does not have what is prescribed";
    }
  }
}

// Without a force there is no slip, however small the strength of a fault that slides anyway.
TEST(Prescribed, RestsWithoutForce)
{
  auto halves = variousHalves("Regularised");
  for (auto& half : halves) {
    half.load = 0;
  }
  const Views views(halves);
  const int num_nodes = static_cast<int>(halves.size());
  EXPECT_EQ(views.fault->kernels->minimise(allNodes(num_nodes), views.curvature, views.r, views.at,
                                           views.v),
            0);
  const auto v = toHost(views.v);
  for (int i = 0; i < num_nodes; ++i) {
    EXPECT_EQ(v(i, 0), 0);
  }
}

// All other kernels see the sum of the unknown and of what is prescribed.
TEST(Prescribed, AddsToTheVelocityElsewhere)
{
  const auto halves = variousHalves("Truncated");
  const Views views(halves);
  const auto n = halves.size();
  std::vector<Values> sums, steps;
  for (auto const& half : halves) {
    sums.push_back({half.guess, half.prescribed});
    steps.push_back({0.3 * half.guess, 0});
  }
  const auto sum = toDevice(sums), step = toDevice(steps);
  auto const& kernels = *views.fault->kernels;
  auto const& plain = views.fault->at;
  EXPECT_EQ(kernels.slope(views.v, step, 0.5, views.at), kernels.slope(sum, step, 0.5, plain));
  EXPECT_EQ(kernels.difference(views.v, step, views.at).change,
            kernels.difference(sum, step, plain).change);
  const BlockView gradient("gradient", n, 2), other_gradient("gradient", n, 2);
  const HessianView hessian("hessian", n, 2, 2), other_hessian("hessian", n, 2, 2);
  const FlagView kinked("kinked", n);
  kernels.linearise(views.v, views.at, gradient, hessian, kinked);
  kernels.linearise(sum, plain, other_gradient, other_hessian, kinked);
  const auto g = toHost(gradient), other_g = toHost(other_gradient);
  const auto H = toHost(hessian), other_H = toHost(other_hessian);
  for (std::size_t i = 0; i < n; ++i) {
    for (int j = 0; j < 2; ++j) {
      EXPECT_EQ(g(i, j), other_g(i, j));
      EXPECT_EQ(H(i, j, 1 - j), other_H(i, j, 1 - j));
    }
  }
}
} // namespace asperity::friction::test
