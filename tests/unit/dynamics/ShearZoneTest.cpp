#include "dynamics/processes/ShearZone.hpp"
#include "base/Views.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

// Heat and fluid across a fault against integrals in time of the exact response to a pulse of heat.
namespace asperity::dynamics
{
namespace
{
const double root_two_pi = std::sqrt(2 * std::acos(-1.));
constexpr int default_modes = 60;

// TPV105 of SCEC, but for the temperature.
struct Rock
{
  double thermal = 1e-6, hydraulic = 4e-4, heat_capacity = 2.7e6, pressure_per_temperature = 1e5;
  double half_width = 0.02, T0 = 300, p0 = 5e6;

  // T and p at y = 0 after heat of 1 J/m^2 at t = 0 [K m^2/J, Pa m^2/J].
  double temperatureOfPulse(double t) const
  {
    return 1 / (root_two_pi * heat_capacity * width(thermal, t));
  }
  double pressureOfPulse(double t) const
  {
    const double size = pressure_per_temperature / (root_two_pi * heat_capacity);
    if (hydraulic == thermal) {
      const double w2 = half_width * half_width;
      return size * (w2 + thermal * t) / std::pow(width(thermal, t), 3);
    }
    return size * (hydraulic / width(hydraulic, t) - thermal / width(thermal, t)) /
           (hydraulic - thermal);
  }
  // The integral of temperatureOfPulse from 0 to t.
  double temperatureOfHeating(double t) const
  {
    return spread(thermal, t) / (root_two_pi * heat_capacity);
  }
  double pressureOfHeating(double t) const
  {
    return pressure_per_temperature / (root_two_pi * heat_capacity) *
           (hydraulic * spread(hydraulic, t) - thermal * spread(thermal, t)) /
           (hydraulic - thermal);
  }

private:
  double width(double diffusivity, double t) const
  {
    return std::sqrt(half_width * half_width + 2 * diffusivity * t);
  }
  // (width(t) - width(0)) / diffusivity
  double spread(double diffusivity, double t) const
  {
    return 2 * t / (width(diffusivity, t) + half_width);
  }
};

NodeView nodeOf(double value)
{
  return toDevice(std::vector<double>{value}, "asperity::test::node");
}
double valueOf(NodeView const& view) { return toHost(view)(0); }

// One node.
class Zone
{
public:
  explicit Zone(Rock const& rock, int num_modes = default_modes)
      : zone_({nodeOf(rock.thermal), nodeOf(rock.hydraulic), nodeOf(rock.heat_capacity),
               nodeOf(rock.pressure_per_temperature), nodeOf(rock.half_width), nodeOf(rock.T0),
               nodeOf(rock.p0)},
              num_modes)
      , temperature_(nodeOf(rock.T0))
      , pressure_(rock.p0)
  {
    for (int i = 0; i < num_modes; ++i) {
      modes_.temperature.push_back(nodeOf(0));
      modes_.pressure.push_back(nodeOf(0));
    }
  }

  double temperature() const { return valueOf(temperature_); }
  double pressure() const { return pressure_; }
  double heat() const { return valueOf(modes_.temperature.back()); } // over rho c

  // A step with the heat that q(p at its end) gives, where q is linear.
  void advance(double tau, std::function<double(double)> const& q)
  {
    const NodeView rest = nodeOf(0), per_heat = nodeOf(0);
    zone_.pressureAfter(modes_, tau, rest, per_heat);
    const double r = valueOf(per_heat), slope = q(1) - q(0);
    pressure_ = (valueOf(rest) + r * q(0)) / (1 - r * slope);
    zone_.advance(modes_, tau, nodeOf(q(pressure_)), modes_, temperature_);
  }
  void advance(double tau, double q)
  {
    advance(tau, [=](double) { return q; });
  }

private:
  ShearZone zone_;
  ShearZone::Modes modes_;
  NodeView temperature_;
  double pressure_;
};

// Slip at V = 1 m/s with constant friction.
struct Sliding
{
  double friction = 0.6, sigma_n = 100e6;
  double traction(double p) const { return friction * (sigma_n - p); }

  // A step with the mean of the tractions at its ends.
  void advance(Zone& zone, double tau) const
  {
    const double before = traction(zone.pressure());
    zone.advance(tau, [&](double p) { return (before + traction(p)) / 2; });
  }
};

// T - T0 and p - p0 [K, Pa] of the same slip at the times n h, n <= num_steps, by the trapezoidal
// rule.
struct History
{
  std::vector<double> temperature, pressure;
};

History integrate(Rock const& rock, Sliding const& sliding, double h, int num_steps)
{
  std::vector<double> of_T, of_p; // after n h
  for (int n = 0; n <= num_steps; ++n) {
    of_T.push_back(h * rock.temperatureOfPulse(n * h));
    of_p.push_back(h * rock.pressureOfPulse(n * h));
  }
  History all = {{0}, {0}};
  std::vector<double> q = {sliding.traction(rock.p0) / 2}; // the weight of the first value is 1/2
  for (int n = 1; n <= num_steps; ++n) {
    double T = 0, p = 0;
    for (int m = 0; m < n; ++m) {
      T += q[m] * of_T[n - m];
      p += q[m] * of_p[n - m];
    }
    p = (p + of_p[0] / 2 * sliding.traction(rock.p0)) / (1 + of_p[0] / 2 * sliding.friction);
    q.push_back(sliding.traction(rock.p0 + p));
    all.temperature.push_back(T + of_T[0] / 2 * q[n]);
    all.pressure.push_back(p);
  }
  return all;
}
} // namespace

TEST(ShearZone, IsHeatedLikeTheExactZoneForAllTimes)
{
  const Rock rock;
  for (int decade = -8; decade <= 12; ++decade) {
    const double t = std::pow(10., decade), q = 6e7;
    Zone zone(rock);
    zone.advance(t, q);
    EXPECT_NEAR((zone.temperature() - rock.T0) / (q * rock.temperatureOfHeating(t)), 1, 1e-5) << t;
    EXPECT_NEAR((zone.pressure() - rock.p0) / (q * rock.pressureOfHeating(t)), 1, 1e-5) << t;
    const double later = 10 * t;
    zone.advance(later - t, 0.);
    const auto left = [&](auto const& of) {
      return q * ((rock.*of)(later) - (rock.*of)(later - t));
    };
    EXPECT_NEAR((zone.temperature() - rock.T0) / left(&Rock::temperatureOfHeating), 1, 1e-5) << t;
    EXPECT_NEAR((zone.pressure() - rock.p0) / left(&Rock::pressureOfHeating), 1, 1e-5) << t;
  }
}

TEST(ShearZone, NeedsNoMoreModesThanTheDefaultForOnePartInThousand)
{
  const Rock rock;
  const auto errorWith = [&](int num_modes) {
    double error = 0;
    for (double t : {1e-4, 0.1, 1., 30., 1e4}) {
      Zone zone(rock, num_modes);
      zone.advance(t, 6e7);
      error = std::max(
        error, std::abs((zone.pressure() - rock.p0) / (6e7 * rock.pressureOfHeating(t)) - 1));
    }
    return error;
  };
  EXPECT_GT(errorWith(15), 1e-3);
  EXPECT_LT(errorWith(default_modes), 1e-3);
  EXPECT_LT(errorWith(2 * default_modes), 1e-8);
}

TEST(ShearZone, WeakensLikeTheIntegralEquation)
{
  const Sliding sliding;
  Rock thin, alike, reversed;
  thin.half_width = 1e-3;
  alike.thermal = alike.hydraulic = 1e-5;
  reversed.hydraulic = 1e-7;
  for (auto const& rock : {Rock(), thin, alike, reversed}) {
    const int num_steps = 2000;
    const double h = 0.5 / num_steps;
    const int parts = 4; // of a step, since the rule is poor while there are few of them
    const auto expected = integrate(rock, sliding, h / parts, num_steps * parts);
    Zone zone(rock);
    for (int n = 1; n <= num_steps; ++n) {
      sliding.advance(zone, h);
      EXPECT_NEAR((zone.temperature() - rock.T0) / expected.temperature[n * parts], 1, 1e-3) << n;
      EXPECT_NEAR((zone.pressure() - rock.p0) / expected.pressure[n * parts], 1, 1e-3) << n;
    }
  }
}

// Rice (2006): with x = slip / L*, traction = f (sigma - p0) exp(x) erfc(sqrt(x)),
// L* = 4 / f^2 (rho c / Lambda)^2 (sqrt(alpha_hy) + sqrt(alpha_th))^2 / V.
TEST(ShearZone, WeakensLikeSlipOnAPlaneWhereItIsThin)
{
  const Sliding sliding;
  Rock rock;
  rock.half_width = 1e-7;
  const double length =
    4 * std::pow(rock.heat_capacity / (sliding.friction * rock.pressure_per_temperature) *
                   (std::sqrt(rock.hydraulic) + std::sqrt(rock.thermal)),
                 2);
  Zone zone(rock);
  const double growth = std::pow(10., 1. / 40);
  double t = 1e-9 * length;
  sliding.advance(zone, t);
  while (t < 10 * length) {
    const double next = growth * t;
    sliding.advance(zone, next - t);
    t = next;
    const double x = t / length;
    EXPECT_NEAR(sliding.traction(zone.pressure()) / sliding.traction(rock.p0),
                std::exp(x) * std::erfc(std::sqrt(x)), 1e-3)
      << x;
  }
}

TEST(ShearZone, WeakensExponentiallyWithoutDiffusion)
{
  const Sliding sliding;
  Rock rock;
  rock.thermal = 1e-20;
  rock.hydraulic = 3e-20;
  const double height = root_two_pi * rock.half_width; // of the layer with the same heat at y = 0
  const double length =
    rock.heat_capacity * height / (sliding.friction * rock.pressure_per_temperature);
  Zone zone(rock);
  for (int n = 1; n <= 300; ++n) {
    sliding.advance(zone, length / 100);
    EXPECT_NEAR(sliding.traction(zone.pressure()) / sliding.traction(rock.p0), std::exp(-n / 100.),
                1e-5)
      << n;
  }
}

TEST(ShearZone, KeepsItsHeatAndDoesNotDependOnTheSteps)
{
  const Rock rock;
  Zone whole(rock), halves(rock);
  whole.advance(3., 6e7);
  halves.advance(1.2, 6e7);
  halves.advance(1.8, 6e7);
  EXPECT_NEAR(whole.heat() * rock.heat_capacity / (3. * 6e7), 1, 1e-14);
  EXPECT_NEAR(halves.heat() / whole.heat(), 1, 1e-14);
  EXPECT_NEAR(halves.temperature() / whole.temperature(), 1, 1e-13);
  EXPECT_NEAR(halves.pressure() / whole.pressure(), 1, 1e-13);
  whole.advance(1e12, 0.);
  EXPECT_NEAR(whole.heat() / halves.heat(), 1, 1e-14);
}
} // namespace asperity::dynamics
