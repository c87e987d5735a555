#include "base/parallel/Reductions.hpp"
#include "dynamics/processes/DiffusionStep.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "unit/dynamics/SmallModel.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Diffusion along faults that cross or join.
namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
constexpr double off = 1e-9;
constexpr double diffusivity = 0.1; // m^2/s
constexpr double arm = 2;           // m, its length
constexpr int cells_of_arm = 8;

// Faults inside a square of two arms, or a boundary of it, as one surface.
struct Network
{
  explicit Network(GlobalMesh<2> const& whole, std::string const& boundary)
      : model(optionsOf(whole, boundary), fem::test::worldCommunicator())
      , mesh(fem::makeFaultMesh(model.mesh, *model.surface))
  {
    std::vector<double> weights, c(model.surface->numNodes(), diffusivity);
    for (auto const& node : *model.surface) {
      weights.push_back(node.weight);
    }
    S = mesh->points().sums(weights);
    step =
      std::make_unique<DiffusionStep>(mesh->stiffness(c), S, std::vector<bool>(S.size(), false));
  }

  static OptionsIn<2> optionsOf(GlobalMesh<2> const& whole, std::string const& boundary)
  {
    OptionsIn<2> options;
    options.components = 1;
    options.mesh = whole;
    options.fault = boundary;
    options.other_side =
      whole.faults.empty() ? fem::OtherSide::rigid_foundation : fem::OtherSide::body;
    return options;
  }

  // The pressure (num_nodes) after 10 s, into which `rate` flows at a place.
  NodeView after10s(std::array<double, 3> const& place, double rate) const
  {
    auto const& points = mesh->points();
    std::vector<double> rates(model.surface->numNodes(), 0.);
    for (auto const& [node, share] : mesh->nearest(place).shares) {
      rates[node] += rate * share;
    }
    auto const q = points.sums(rates);
    const NodeView p("asperity::test::p", points.numPoints());
    double volume = 0;
    for (int i = 0; i < 20; ++i) {
      step->advance(0.5, p, {q, q}, p);
      volume += 0.5 * rate;
      EXPECT_NEAR(volumeOf(p), volume, 1e-10 * rate);
    }
    const NodeView at_nodes("asperity::test::p", model.surface->numNodes());
    points.scatter(p, at_nodes);
    return at_nodes;
  }

  double volumeOf(NodeView const& p) const
  {
    auto const host = toHost(p);
    double mine = 0;
    for (std::size_t i = 0; i < S.size(); ++i) {
      mine += S[i] * host(i);
    }
    return sumOverRanks(mine, *fem::test::worldCommunicator());
  }

  // By the number of cells from a place, over all ranks; it must be the same in all directions.
  std::vector<double> byDistance(NodeView const& p, std::array<double, 3> const& from) const
  {
    auto const host = toHost(p);
    std::vector<double> least(cells_of_arm + 1, 1e9), largest(cells_of_arm + 1, -1e9);
    for (int node = 0; node < model.surface->numNodes(); ++node) {
      auto const& x = (*model.surface)[node].place;
      const auto n = static_cast<std::size_t>(
        std::lround(std::hypot(x[0] - from[0], x[1] - from[1]) * cells_of_arm / arm));
      least.at(n) = std::min(least[n], host(node));
      largest.at(n) = std::max(largest[n], host(node));
    }
    const auto communicator = fem::test::worldCommunicator();
    for (std::size_t n = 0; n < least.size(); ++n) {
      least[n] = minOverRanks(least[n], *communicator);
      largest[n] = maxOverRanks(largest[n], *communicator);
      EXPECT_NEAR(least[n], largest[n], 1e-9) << n;
    }
    return least;
  }

  ModelIn<2> model;
  std::shared_ptr<const fem::FaultMesh> mesh;
  std::vector<double> S;
  std::unique_ptr<DiffusionStep> step;
};

// A square of two arms with a level fault through its middle and a vertical one from y = `from` to
// the top, both with the name of `all`, too.
GlobalMesh<2> squareWith(double from)
{
  auto whole = fem::test::uniformRectangle(2 * cells_of_arm, 2 * cells_of_arm, 2 * arm, 2 * arm);
  mesh::addFaults<2>(
    whole, {{"level", [](auto& x) { return std::abs(x[1] - arm) < off; }},
            {"upright", [=](auto& x) { return std::abs(x[0] - arm) < off && x[1] > from - off; }}});
  mesh::splitFaults(whole, "test");
  auto& all = whole.boundaries["all"];
  for (auto const* name : {"level", "upright"}) {
    auto const& facets = whole.boundaries.at(name);
    all.insert(all.end(), facets.begin(), facets.end());
  }
  return whole;
}

// On a line of the length of an arm, into whose end 1 m^2/s flows.
std::vector<double> onAnArm()
{
  const Network line(fem::test::uniformRectangle(cells_of_arm, 2, arm, 1), "bottom");
  return line.byDistance(line.after10s({0, 0, 0}, 1), {0, 0, 0});
}
} // namespace

TEST(FlowAcrossJoints, IsSharedByTheArms)
{
  auto const expected = onAnArm();
  const double t = 10, largest = 2 * std::sqrt(t / (M_PI * diffusivity)); // of a half line
  EXPECT_NEAR(expected[0], largest, 0.01 * largest);
  for (const bool do_cross : {true, false}) {
    const Network faults(squareWith(do_cross ? 0 : arm), "all");
    EXPECT_EQ(faults.mesh->points().numJoints(), 1);
    auto const found =
      faults.byDistance(faults.after10s({arm, arm, 0}, do_cross ? 4 : 3), {arm, arm, 0});
    for (std::size_t n = 0; n < expected.size(); ++n) {
      EXPECT_NEAR(found[n], expected[n], 1e-9) << n;
    }
  }
}

// Water that enters one fault fills both, and stays.
TEST(FlowAcrossJoints, FillsAllFaults)
{
  const Network faults(squareWith(0), "all");
  const NodeView p("asperity::test::p", faults.S.size());
  auto const at_tip = faults.mesh->nearest({0, arm, 0});
  std::vector<double> rates(faults.model.surface->numNodes(), 0.);
  for (auto const& [node, share] : at_tip.shares) {
    rates[node] += share;
  }
  auto const q = faults.mesh->points().sums(rates);
  const std::vector<double> none(q.size(), 0.);
  faults.step->advance(1, p, {q, q}, p);
  for (int i = 0; i < 20; ++i) {
    faults.step->advance(50, p, {none, none}, p);
  }
  EXPECT_NEAR(faults.volumeOf(p), 1, 1e-9);
  for (const double value : toVector(p)) {
    EXPECT_NEAR(value, 1 / (4 * arm), 1e-9); // over the length of both
  }
}
} // namespace asperity::dynamics
