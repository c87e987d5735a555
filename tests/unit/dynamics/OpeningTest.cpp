#include "dynamics/coupling/CoupledStep.hpp"
#include "dynamics/fault/OpeningForces.hpp"
#include "dynamics/observables/EnergyBalance.hpp"
#include "fem/NodalDamping.hpp"
#include "fem/SupportWeights.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "unit/dynamics/SmallModel.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

// A fault that may open, in bodies whose motion is known by hand: all deform in y alone, between
// walls, as bars with the modulus K + 4/3 G.
namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
constexpr double K = 5e4, G = 2.3e4, density = 900, modulus = K + 4 * G / 3;
constexpr double pressed = 2000; // Pa, the normal stress at the start
constexpr double off = 1e-9;

// [0, 1/2] x [0, 2 length], cut at half of its height.
GlobalMesh<2> twoBars(int cells, double length)
{
  auto mesh = fem::test::uniformRectangle(2, 2 * cells, 0.5, 2 * length);
  mesh::addFaults<2>(
    mesh, {{"fault", [length](Point<2> const& x) { return std::abs(x[1] - length) < off; }}});
  mesh::splitFaults(mesh, "test");
  return mesh;
}

// The same in space: a unit square times 2 length.
GlobalMesh<3> twoColumns(int cells, double length)
{
  auto mesh = fem::test::uniformBox({2, 2 * cells, 2}, {1, 2 * length, 1});
  mesh::addFaults<3>(
    mesh, {{"fault", [length](Point<3> const& x) { return std::abs(x[1] - length) < off; }}});
  mesh::splitFaults(mesh, "test");
  return mesh;
}

// A normal stress counts with 50 times its relative change, of which 1e-13 is within rounding.
CouplingSettings coupling()
{
  auto settings = tightCoupling();
  settings.tolerance = 1e-8;
  return settings;
}

// Between walls; top and bottom are free.
template <int Dim>
OptionsIn<Dim> barsBetweenWalls(GlobalMesh<Dim> const& mesh)
{
  OptionsIn<Dim> options;
  options.mesh = mesh;
  options.fault = "fault";
  options.other_side = fem::OtherSide::body;
  options.other_side.may_open = true;
  options.material = {density, K, G, 0, 0};
  options.sigma_n = pressed;
  for (std::string const wall : {"left", "right"}) {
    options.conditions.push_back({wall, wall, fem::SlidingWall{}});
  }
  if constexpr (Dim == 3) {
    for (std::string const wall : {"front", "back"}) {
      options.conditions.push_back({wall, wall, fem::SlidingWall{}});
    }
  }
  return options;
}

template <int Dim>
void hold(OptionsIn<Dim>& options, std::string const& boundary,
          std::function<double(double)> const& velocity)
{
  std::vector<double> up(Dim, 0.);
  up[1] = 1;
  options.conditions.push_back(
    {boundary, boundary, fem::PrescribedVelocity<Dim>{up, [velocity](Point<Dim> const&, double t) {
                                                        return velocity(t);
                                                      }}});
}

// What steps bars. The normal stress follows the reaction across the fault.
template <int Dim>
struct Bars
{
  Bars(OptionsIn<Dim> const& options, bool is_massless, RateUpdate const& update,
       DyadicTime const& time, Correction correction = Correction::direct)
      : model(options, fem::test::selfCommunicator())
      , body(bodyOf(is_massless))
      , fault(model.surface, model.fault.laws(),
              model.fault.normalStress().following(NormalStressChange::coupled, 0))
      , state(model.restingState())
      , since_start(
          reactionSince(state.motion(), body,
                        std::make_shared<NormalReaction>(
                          body, *model.surface, model.constraints->frames(),
                          fem::supportWeights(model.mesh, *model.surface, options.conditions))))
      , clock(time)
      , step(body, fault, {update, clock, coupling(), tightSettings(correction), 1u << 30},
             since_start)
      , balance(body, fault, clock, since_start)
  {
  }

  void start() { balance.start(state); }

  void advance(int level = 0)
  {
    auto next = state.clone();
    ASSERT_TRUE(step.solve(state, level, next, count).solved());
    state = next;
    balance.advance(state);
  }

  double time() const { return clock.seconds(state.time); }
  Eigen::VectorXd opening() const { return denseOf(openingOf(*model.surface, *state.u)); }
  Eigen::VectorXd stress() const { return denseOf(state.sigma_n); }
  double mechanicalEnergy() const { return balance.energy().kinetic + balance.energy().elastic; }

  ModelIn<Dim> model;
  Body body;
  Fault fault;
  State state;
  ReactionSinceStart since_start;
  DyadicTime clock;
  CoupledStep step;
  EnergyBalance balance;
  SolveCount count;

private:
  Body bodyOf(bool is_massless) const
  {
    auto result = model.body;
    if (is_massless) {
      result.matrices.mass = fem::zeroLike(*result.matrices.mass);
      result.matrices.is_massless = true;
    }
    return result;
  }
};

void expectAll(Eigen::VectorXd const& values, double expected, double tolerance)
{
  ASSERT_GT(values.size(), 0);
  EXPECT_NEAR(values.minCoeff(), expected, tolerance);
  EXPECT_NEAR(values.maxCoeff(), expected, tolerance);
}

struct Scheme
{
  RateUpdate update;
  // The lift m steps of tau after a velocity r has turned to -r, beyond that of the turn in no
  // time, over r tau.
  std::function<double(int)> lag;
};

// It has no other velocity than that at the end of the step.
Scheme backwardEuler()
{
  return {RateUpdate::backwardEuler(), [](int) { return 0.; }};
}

// Newmark's two equations for the algorithmic acceleration A,
//   gamma A1 = (v1 - v0) / tau - (1 - gamma) A0
//   u1 = u0 + tau v0 + tau^2 ((1/2 - beta) A0 + beta A1)
// give A = -2 r / (gamma tau) for the turn, and q = -(1 - gamma) / gamma of the last A in each step
// after it. The sum of u1 is 1 + (1 - 2 beta / gamma) q^(m - 1). The spectral radius 1/2 means
// gamma = 5/6 and beta = 4/9.
Scheme generalisedAlpha()
{
  return {RateUpdate::generalisedAlpha(0.5),
          [](int m) { return 1 - std::pow(-1. / 5, m - 1) / 15; }};
}

// Lifted by U at the top, bars of twice the unit length bear pressed - modulus U / 2 until that
// vanishes; beyond, they are apart by what U exceeds that of then. Put back, they are as before.
template <int Dim>
void liftAndPutBack(GlobalMesh<Dim> const& mesh, Scheme const& scheme, Correction correction)
{
  const double until_open = 2 * pressed / modulus, rate = until_open / 3;
  auto options = barsBetweenWalls<Dim>(mesh);
  hold(options, "bottom", [](double) { return 0.; });
  hold(options, "top", [rate](double t) { return t <= 6 + off ? rate : -rate; });
  Bars<Dim> bars(options, true, scheme.update, DyadicTime(1, 2), correction);
  bars.start();
  double largest = 0;
  for (int n = 1; n <= 12; ++n) {
    bars.advance();
    SCOPED_TRACE(bars.time());
    // What the scheme has made of the velocity at the top.
    double lift = 0;
    auto const u = denseOf(*bars.state.u);
    for (int node = 0; node < bars.model.mesh.num_owned; ++node) {
      if (bars.model.mesh.vertices[node][1] > 2 - off) {
        lift = bars.model.valueAt(*bars.state.u, node)[1];
      }
    }
    const double steps = n <= 6 ? n : 12 - n + scheme.lag(n - 6);
    EXPECT_NEAR(lift, rate * steps, 1e-12 * until_open);
    expectAll(bars.stress(), std::max(pressed - modulus * lift / 2, 0.), 1e-8 * pressed);
    expectAll(bars.opening(), std::max(lift - until_open, 0.), 1e-10 * until_open);
    largest = std::max(largest, bars.opening().maxCoeff());
    EXPECT_NEAR(bars.balance.energy().defect, 0, 1e-9 * modulus * until_open * until_open);
  }
  EXPECT_GT(largest, 0.8 * until_open);
  EXPECT_EQ(bars.count.energy_increases, 0);
}
} // namespace

TEST(Opening, LiftsABarAndPutsItBack)
{
  for (auto const correction : {Correction::direct, Correction::multigrid}) {
    for (auto const& scheme : {backwardEuler(), generalisedAlpha()}) {
      SCOPED_TRACE(scheme.update.name);
      liftAndPutBack<2>(twoBars(4, 1), scheme, correction);
    }
    liftAndPutBack<3>(twoColumns(3, 1), backwardEuler(), correction);
  }
}

// A fault between bodies that press each other, and one that must not open, are the same.
TEST(Opening, IsShutLikeABilateralFaultWhileItIsPressed)
{
  auto options = barsBetweenWalls<2>(twoBars(4, 1));
  hold(options, "bottom", [](double) { return 0.; });
  hold(options, "top", [](double t) { return -1e-3 * std::sin(t); });
  options.traction = 1500;
  Bars<2> bars(options, true, RateUpdate::backwardEuler(), DyadicTime(0.5, 1));
  options.other_side.may_open = false;
  Bars<2> shut(options, true, RateUpdate::backwardEuler(), DyadicTime(0.5, 1));
  for (int n = 0; n < 6; ++n) {
    bars.advance();
    shut.advance();
    expectAll(bars.opening(), 0, 1e-16);
    const Eigen::VectorXd difference = denseOf(*bars.state.u) - denseOf(*shut.state.u);
    EXPECT_LE(difference.cwiseAbs().maxCoeff(),
              1e-6 * denseOf(*shut.state.u).cwiseAbs().maxCoeff());
    EXPECT_NEAR(bars.balance.energy().contact_work, 0, 1e-12);
  }
}

namespace
{
// A constant pressure of fluid.
class Pressure : public FaultProcess
{
public:
  explicit Pressure(std::vector<double> const& values) : values_(toDevice(values, "pressure")) {}
  std::vector<State::Added> fields(State const&) const override { return {}; }
  std::vector<std::shared_ptr<StepUnknown>> unknowns() const override { return {}; }
  void act(State const&, NodeView const&, NodeView const& sigma_n) const override
  {
    auto const p = values_;
    Kokkos::parallel_for(
      "asperity::test::act", RangePolicy(0, sigma_n.extent_int(0)), KOKKOS_LAMBDA(int node) {
        sigma_n(node) = sigma_n(node) > p(node) ? sigma_n(node) - p(node) : 0;
      });
  }
  void addPressure(State const&, NodeView const& p) const override
  {
    Kokkos::deep_copy(p, values_);
  }

private:
  ConstNodeView values_;
};
} // namespace

// Held at top and bottom, the bars are parted by what p exceeds the normal stress at the start; the
// fault bears p. A lower pressure leaves them as they are.
TEST(Opening, IsOpenedByAPressureAboveTheNormalStress)
{
  for (const double p : {0.5 * pressed, 1.5 * pressed}) {
    auto options = barsBetweenWalls<2>(twoBars(4, 1));
    hold(options, "bottom", [](double) { return 0.; });
    hold(options, "top", [](double) { return 0.; });
    options.processes = [p](fem::FaultSurface const& surface) -> FaultProcesses {
      return {std::make_shared<Pressure>(std::vector<double>(surface.numNodes(), p))};
    };
    Bars<2> bars(options, true, RateUpdate::backwardEuler(), DyadicTime(1, 1));
    bars.advance();
    bars.advance();
    const double excess = std::max(p - pressed, 0.);
    expectAll(bars.opening(), 2 * excess / modulus, 1e-10 * pressed / modulus);
    expectAll(bars.stress(), std::max(p, pressed), 1e-8 * pressed);
    expectAll(denseOf(bars.fault.effectiveStress(bars.state)), pressed - p + excess,
              1e-8 * pressed);
  }
}

namespace
{
constexpr double length = 1, met_with = 0.1, gap = 2e-4; // of each bar [m], [m/s]; between them [m]

// Two bars of length L meet with a velocity of V each. While waves run through them and back, for
// T = 2 L / c, they press each other with density c V; then they part with the velocity with which
// they met. Contact keeps momentum, and no step gains energy.
struct Collision
{
  explicit Collision(RateUpdate const& update, int steps);

  double wave = std::sqrt(modulus / density), duration = 2 * length / wave, step;
  double first = 0, last = 0;      // times with a tenth of the stress or more
  double impulse = 0;              // as a part of what turns the velocity
  double velocity = 0, energy = 0; // of the upper bar at the end, over that before; likewise
  double least_opening = 0;
  double work = 0; // of contact, over the energy
};

Collision::Collision(RateUpdate const& update, int steps) : step(2 * duration / steps)
{
  constexpr double V = met_with;
  auto options = barsBetweenWalls<2>(twoBars(64, length));
  options.sigma_n = 0;
  Bars<2> bars(options, false, update, DyadicTime(step, 1));
  const auto isUpper = [&](int vertex) {
    auto const& splits = bars.model.mesh.splits;
    return bars.model.mesh.vertices[vertex][1] > length + off ||
           std::any_of(splits.begin(), splits.end(),
                       [vertex](auto const& split) { return split.plus == vertex; });
  };
  const auto setEachBar = [&](Vector& x, double upper, double lower) {
    std::vector<double> along_axes;
    for (int vertex = 0; vertex < bars.model.mesh.num_owned; ++vertex) {
      along_axes.insert(along_axes.end(), {0., isUpper(vertex) ? upper : lower});
    }
    auto const unknowns = fem::unknownsOf(bars.model.constraints->frames(), along_axes);
    for (std::size_t dof = 0; dof < unknowns.size(); ++dof) {
      x.replaceLocalValue(static_cast<int>(dof), unknowns[dof]);
    }
  };
  setEachBar(*bars.state.u, gap / 2, -gap / 2);
  setEachBar(*bars.state.v, -V, V);
  const double meet = gap / (2 * V);
  auto const mass = denseOf(*bars.body.matrices.mass);
  auto const one = bars.body.vector(), upper = bars.body.vector();
  setEachBar(*one, 1, 1);
  setEachBar(*upper, 1, 0);
  const auto velocityOf = [&](RCP<Vector> const& which) {
    const Eigen::VectorXd momentum = mass * denseOf(*which);
    return momentum.dot(denseOf(*bars.state.v)) / momentum.dot(denseOf(*which));
  };
  bars.start(); // without strain: each bar has moved as a whole
  expectAll(bars.opening(), gap, 1e-15);
  const double at_start = bars.mechanicalEnergy();
  EXPECT_NEAR(at_start, density * length * 0.5 * V * V, 1e-6 * at_start);
  auto const weights = denseOf(bars.model.surface->weights());
  double before = at_start;
  for (int n = 0; n < steps; ++n) {
    bars.advance();
    EXPECT_LE(bars.mechanicalEnergy(), before + 1e-11 * at_start) << bars.time();
    before = bars.mechanicalEnergy();
    EXPECT_NEAR(velocityOf(one), 0, 1e-10 * V);
    least_opening = std::min(least_opening, bars.opening().minCoeff());
    const double stress = bars.stress().dot(weights) / weights.sum();
    impulse += stress * step / (2 * density * length * V);
    if (stress > 0.1 * density * wave * V) {
      first = first == 0 ? bars.time() : first;
      last = bars.time();
    }
    if (std::abs(bars.time() - meet - duration / 2) < duration / 8) {
      EXPECT_NEAR(stress, density * wave * V, 0.01 * density * wave * V) << bars.time();
    }
  }
  EXPECT_NEAR(first, meet, 2 * step);
  EXPECT_NEAR(last - first, duration, 0.05 * duration);
  EXPECT_GT(bars.opening().minCoeff(), gap);
  EXPECT_NEAR(bars.balance.energy().defect, 0, 1e-9 * at_start);
  EXPECT_EQ(bars.count.energy_increases, 0);
  velocity = velocityOf(upper) / V;
  energy = bars.mechanicalEnergy() / at_start;
  work = bars.balance.energy().contact_work / at_start;
}
} // namespace

// Steps of tau smooth the fronts that come back like a normal distribution of variance tau T: the
// bars part when half of both fronts has arrived, which takes the part sqrt(2 / pi) sqrt(tau / T)
// of the impulse.
TEST(Opening, BarsThatCollidePartWithBackwardEuler)
{
  const Collision bars(RateUpdate::backwardEuler(), 512);
  const double lost = std::sqrt(2 / M_PI * bars.step / bars.duration);
  EXPECT_NEAR(1 - bars.impulse, lost, 0.1 * lost);
  EXPECT_NEAR(bars.velocity, 1 - 2 * lost, 0.2 * lost);
  EXPECT_GE(bars.least_opening, -1e-15);
  EXPECT_GT(bars.work, 0);
}

// The trapezoidal rule keeps what an impact leaves; contact neither rings nor gives energy back.
TEST(Opening, BarsThatCollideExchangeTheirVelocities)
{
  for (const int steps : {512, 1024}) {
    const Collision bars(RateUpdate::newmark(0.25), steps);
    EXPECT_NEAR(bars.impulse, 1, 0.015);
    EXPECT_NEAR(bars.velocity, 1, 0.03);
    EXPECT_GT(bars.energy, 0.985);
    EXPECT_LE(bars.energy, 1);
    // Nodes pass each other by less than their way in a step.
    EXPECT_GE(bars.least_opening, -2 * met_with * bars.step);
    EXPECT_NEAR(bars.work, 1 - bars.energy, 1e-6) << "all that is lost is lost in contact";
  }
}
} // namespace asperity::dynamics
