#include "dynamics/RateUpdate.hpp"

#include "unit/dynamics/OneDof.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace asperity::dynamics
{
using namespace testing;

namespace
{
// What a step of tau = 1 s makes of (u, v tau, A tau^2), after one `stretch` times shorter.
Eigen::Matrix3d amplification(RateUpdate const& update, Oscillator const& o, double stretch = 1)
{
  OneDof dof;
  Eigen::Matrix3d result;
  for (int column = 0; column < 3; ++column) {
    const Eigen::Vector3d x = Eigen::Vector3d::Unit(column);
    const double A0 = x[2] * stretch * stretch;
    auto const end = dof.step(update, {x[0], x[1] * stretch, A0, A0}, 1, o);
    result.col(column) << end.u, end.v, end.a_lagging;
  }
  return result;
}

double spectralRadius(Eigen::Matrix3d const& matrix)
{
  return matrix.eigenvalues().cwiseAbs().maxCoeff();
}

// A mode far faster than the step, with mass and without: omega tau = 1e6, k tau / c = 1e12.
const Oscillator with_mass = {1, 0, 1e12}, without_mass = {0, 1, 1e12};

Motion inBalance(Oscillator const& o, double u, double v)
{
  const double a = -(o.c * v + o.k * u) / o.m;
  return {u, v, a, a};
}

double energy(Oscillator const& o, Motion const& motion)
{
  return (o.m * motion.v * motion.v + o.k * motion.u * motion.u) / 2;
}

// Distance in u and v from u'' + 0.3 u' + 4 u = 0, u(0) = 1, u'(0) = 0.5, at t = 4 s, after n steps of 1/n,
// n of 2/n and n of 1/n s.
double errorAfter(RateUpdate const& update, int n)
{
  const Oscillator o = {1, 0.3, 4};
  OneDof dof;
  auto motion = inBalance(o, 1, 0.5);
  for (double size : {1., 2., 1.}) {
    for (int step = 0; step < n; ++step) {
      motion = dof.step(update, motion, size / n, o);
    }
  }
  const double decay = o.c / 2, omega = std::sqrt(o.k - decay * decay), t = 4;
  const double p = 1, q = (0.5 + decay) / omega;
  const double cosine = std::cos(omega * t), sine = std::sin(omega * t);
  const double u = std::exp(-decay * t) * (p * cosine + q * sine);
  const double v = -decay * u + omega * std::exp(-decay * t) * (q * cosine - p * sine);
  return std::hypot(motion.u - u, motion.v - v);
}
} // namespace

TEST(RateUpdateStability, fastModesAreMultipliedByTheSpectralRadius)
{
  for (double rho : {0., 0.3, 0.5, 0.9, 1.}) {
    for (auto const& o : {with_mass, without_mass}) {
      // The eigenvalues coincide in the limit: perturbed by 1e-12 they move by up to 1e-4.
      EXPECT_NEAR(spectralRadius(amplification(RateUpdate::generalisedAlpha(rho), o)), rho, 2e-4);
    }
  }
  EXPECT_NEAR(spectralRadius(amplification(RateUpdate::newmark(0.25), with_mass)), 1, 2e-4);
  EXPECT_NEAR(spectralRadius(amplification(RateUpdate::backwardEuler(), with_mass)), 0, 2e-4);
}

TEST(RateUpdateStability, noStepOfAnySizeAmplifies)
{
  for (double rho : {0., 0.3, 0.5, 0.9, 1.}) {
    for (double omega = 1e-2; omega < 1e6; omega *= 1.7) {
      for (double damping : {0., 1e-3, 0.1, 10.}) { // c tau / m
        const Oscillator o = {1, damping, omega * omega};
        EXPECT_LE(spectralRadius(amplification(RateUpdate::generalisedAlpha(rho), o)), 1 + 1e-7)
          << rho << " " << omega << " " << damping;
      }
    }
  }
}

// After an event every step may be twice as long as the last. In the limit of a fast mode
// (u, v tau, A tau^2) then has the radius 1 for rho = 0 and 2 sqrt(2) rho beyond: v, of which
// that is 2 in units of 1 / tau, dies away with every rho < 1 / sqrt(2), and for rho = 1 stays.
TEST(RateUpdateStability, velocitiesOfFastModesDoNotGrowWhileStepsDouble)
{
  for (auto const& o : {with_mass, without_mass}) {
    auto const radius = [&o](double rho) {
      return spectralRadius(amplification(RateUpdate::generalisedAlpha(rho), o, 2));
    };
    EXPECT_NEAR(radius(0), 1, 1e-3);
    EXPECT_NEAR(radius(0.5), std::sqrt(2), 1e-3);
    EXPECT_GT(radius(0.75), 2);
  }
}

// A mode that the first step resolves, over steps that grow to millions of its period.
TEST(RateUpdateStability, energyDoesNotGrowWhileStepsDouble)
{
  OneDof dof;
  const std::pair<double, double> limits[] = {{0, 1e-8}, {0.5, 1e-3}}; // what is left of it
  for (auto const& [rho, limit] : limits) {
    auto const update = RateUpdate::generalisedAlpha(rho);
    for (double omega = 1e-3; omega < 0.1; omega *= 1.5) {
      const Oscillator o = {1, 0, omega * omega};
      for (auto motion : {inBalance(o, 1 / omega, 0), inBalance(o, 0, 1)}) {
        const double first = energy(o, motion);
        double tau = 1;
        for (int n = 0; n < 25; ++n) {
          motion = dof.step(update, motion, tau, o);
          EXPECT_LE(energy(o, motion), (1 + 1e-6) * first) << rho << " " << omega << " " << n;
          tau *= 2;
        }
        EXPECT_LE(energy(o, motion), limit * first) << rho << " " << omega;
      }
    }
  }
}

// With a given number of changes of the step; where each step differs from the last, generalised
// alpha is of first order (README.md).
TEST(RateUpdateStability, schemesConvergeWithTheirOrder)
{
  const std::vector<std::pair<RateUpdate, int>> schemes = {
    {RateUpdate::newmark(0.25), 2},       {RateUpdate::newmark(0.4), 2},
    {RateUpdate::generalisedAlpha(0), 2}, {RateUpdate::generalisedAlpha(0.5), 2},
    {RateUpdate::generalisedAlpha(1), 2}, {RateUpdate::backwardEuler(), 1}};
  for (auto const& [update, order] : schemes) {
    EXPECT_EQ(update.order, order);
    EXPECT_NEAR(std::log2(errorAfter(update, 200) / errorAfter(update, 400)), order, 0.05)
      << update.name;
  }
}
} // namespace asperity::dynamics
