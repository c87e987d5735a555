#include "dynamics/RateUpdate.hpp"

#include "unit/dynamics/OneDof.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
// What steps of tau = 1 s make of (u, v tau, a tau^2, j tau^3), after one `stretch` times shorter.
Eigen::Matrix4d amplification(RateUpdate const& update, Oscillator const& o, double stretch = 1,
                              int num_steps = 1)
{
  OneDof dof;
  Eigen::Matrix4d result;
  for (int column = 0; column < 4; ++column) {
    const Eigen::Vector4d x = Eigen::Vector4d::Unit(column);
    DofMotion motion = {x[0], x[1] * stretch, x[2] * std::pow(stretch, 2),
                        x[3] * std::pow(stretch, 3)};
    for (int n = 0; n < num_steps; ++n) {
      motion = dof.step(update, motion, 1, o);
    }
    result.col(column) << motion.u, motion.v, motion.a, motion.jerk;
  }
  return result;
}

double spectralRadius(Eigen::Matrix4d const& matrix)
{
  return matrix.eigenvalues().cwiseAbs().maxCoeff();
}

// A mode far faster than the step, with mass and without: omega tau = 1e6, k tau / c = 1e12.
const Oscillator with_mass = {1, 0, 1e12}, without_mass = {0, 1, 1e12};

DofMotion inBalance(Oscillator const& o, double u, double v)
{
  return {u, v, -(o.c * v + o.k * u) / o.m, 0};
}

double energy(Oscillator const& o, DofMotion const& motion)
{
  return (o.m * motion.v * motion.v + o.k * motion.u * motion.u) / 2;
}

// Distance in u and v from u'' + 0.3 u' + 4 u = 0, u(0) = 1, u'(0) = 0.5, at t = 4 s, after steps
// of 1, 2 and 1 times 1/n s, and so on: no change of the step is the last.
double errorAfter(RateUpdate const& update, int n)
{
  const Oscillator o = {1, 0.3, 4};
  OneDof dof;
  auto motion = inBalance(o, 1, 0.5);
  for (int cycle = 0; cycle < n; ++cycle) {
    for (double size : {1., 2., 1.}) {
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

TEST(RateUpdateStability, FastModesAreMultipliedByTheSpectralRadius)
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

TEST(RateUpdateStability, NoStepOfAnySizeAmplifies)
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

// After an event steps grow. Where a step doubles, v is half as much in units of 1 / tau: fast
// modes grow if the spectral radius is above 2.
TEST(RateUpdateStability, VelocitiesOfFastModesDoNotGrowWhileStepsDouble)
{
  for (auto const& o : {with_mass, without_mass}) {
    auto const growth = [&o](double rho, int num_steps) {
      auto const update = RateUpdate::generalisedAlpha(rho);
      return spectralRadius(amplification(update, o, 2, num_steps)) / 2;
    };
    // With every step: not if damping reaches far back.
    for (double rho : {0.36, 0.4, 0.5, 0.6, 0.7, 0.8, 0.81}) {
      EXPECT_LT(growth(rho, 1), 1) << rho;
    }
    for (double rho : {0.33, 0.84}) {
      EXPECT_GT(growth(rho, 1), 1) << rho;
    }
    EXPECT_NEAR(growth(0, 1), 2, 1e-3);
    // With every second step, as RichardsonControl has it.
    for (double rho : {0.01, 0.2, 0.4, 0.5, 0.6, 0.8, 0.86}) {
      EXPECT_LT(growth(rho, 2), 1) << rho;
    }
    EXPECT_GT(growth(0.88, 2), 1);
    EXPECT_NEAR(growth(0, 2), 1, 1e-3);
  }
}

// A mode that the first step resolves, over steps that grow to millions of its period.
TEST(RateUpdateStability, EnergyDoesNotGrowWhileStepsDouble)
{
  struct Case
  {
    double rho;
    int steps_of_each_size;
    double left; // of the energy, in the end
  };
  OneDof dof;
  for (auto const& given : {Case{0.5, 1, 1e-4}, Case{0.5, 2, 1e-8}, Case{0, 2, 1e-9}}) {
    auto const update = RateUpdate::generalisedAlpha(given.rho);
    for (double omega = 1e-3; omega < 0.1; omega *= 1.5) {
      const Oscillator o = {1, 0, omega * omega};
      for (auto motion : {inBalance(o, 1 / omega, 0), inBalance(o, 0, 1)}) {
        const double first = energy(o, motion);
        for (int n = 0; n < 25 * given.steps_of_each_size; ++n) {
          motion = dof.step(update, motion, std::ldexp(1., n / given.steps_of_each_size), o);
          EXPECT_LE(energy(o, motion), 1.03 * first) << given.rho << " " << omega << " " << n;
        }
        EXPECT_LE(energy(o, motion), given.left * first) << given.rho << " " << omega;
      }
    }
  }
}

TEST(RateUpdateStability, SchemesConvergeWithTheirOrderWhileStepsChange)
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
