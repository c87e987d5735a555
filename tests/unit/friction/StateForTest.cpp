#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

#include <cmath>

// The state at which friction has a given value.
namespace asperity::friction::test
{
namespace
{
Values stateFor(Fault const& fault, Values const& V, Values const& mu, int num_failed)
{
  const auto alpha = toDevice(Values(V.size(), -777));
  EXPECT_EQ(fault.kernels->stateFor(toDevice(V), toDevice(mu), alpha), num_failed);
  return toVector(alpha);
}

TEST(StateFor, InvertsTheLawFromRestToFastSlip)
{
  for (auto const& law : both_laws) {
    const auto nodes = variousNodes(law);
    const Fault fault(nodes);
    for (const double V : {1e-300, 1e-20, 1e-9, 1e-6, 1.0, 1e2}) {
      for (const double mu : {1e-12, 1e-3, 0.1, 0.6, 0.9, 30.0}) {
        const auto alpha = stateFor(fault, Values(nodes.size(), V), Values(nodes.size(), mu), 0);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          auto const& reference = nodes[i].law;
          const auto tolerance = static_cast<double>(reference.muTolerance(V, alpha[i]));
          EXPECT_NEAR(static_cast<double>(reference.mu(V, alpha[i])), mu, tolerance)
            << law << ' ' << V << ' ' << mu << ' ' << alpha[i];
        }
      }
    }
  }
}

TEST(StateFor, HasTheStatesOfTheBenchmarks)
{
  // SEAS BP1: log10 theta from tau0 = 26.54612 MPa at both ends of a, radiation damping included.
  const double Vp = 1e-9, eta = 32.0381e9 / (2 * 3464);
  const double tau = 26.54612e6, sigma = 50e6;
  const Fault seas({{{"Regularised", 0.010, 0.015, 1e-6, 0.6}, 1, sigma, 0, 2, 0},
                    {{"Regularised", 0.025, 0.015, 1e-6, 0.6}, 1, sigma, 0, 2, 0}});
  const double mu = (tau - eta * Vp) / sigma;
  const auto alpha = stateFor(seas, {Vp, Vp}, {mu, mu}, 0);
  const auto log_theta = [](double state, double L) {
    return std::log10(L / 1e-6) + state / std::log(10.0);
  };
  // tau0 is printed to seven digits, which b / a magnifies.
  EXPECT_NEAR(log_theta(alpha[0], 0.008), 3.903090, 1e-5);
  EXPECT_NEAR(log_theta(alpha[1], 0.008), 6.903090, 1e-5);

  // SCEC TPV101: 75 MPa on 120 MPa, at rest but for 1e-12 m/s.
  const Fault scec({{{"Regularised", 0.008, 0.012, 1e-6, 0.6}, 1, 120e6, 0, 2, 0}});
  const auto core = stateFor(scec, {1e-12}, {75. / 120}, 0);
  EXPECT_NEAR(0.02 / 1e-6 * std::exp(core[0]) / 1.606239e9, 1, 1e-6);
}

TEST(StateFor, CountsNodesWithoutAStateAndLeavesThemAlone)
{
  for (auto const& law : both_laws) {
    ReferenceNode node{{law, 0.01, 0.015, 1e-6, 0.6}, 1, 1e6, 0, 1, 0};
    const Fault fault({node, node, node, node, node});
    const double nan = std::nan("");
    const auto alpha = stateFor(fault, {0, 1, 1, 1, 1}, {0.6, 0, -0.1, nan, 0.6}, 4);
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(alpha[i], -777);
    }
    EXPECT_NE(alpha[4], -777);
    node.law.b = 0;
    EXPECT_EQ(stateFor(Fault({node}), {1}, {0.1}, 1)[0], -777);
  }
}
} // namespace
} // namespace asperity::friction::test
