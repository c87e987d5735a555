#include "base/parallel/Reductions.hpp"
#include "dynamics/rate/RateSolver.hpp"
#include "fem/BodyMatrices.hpp"
#include "performance/rate_problems/Bp5.hpp"
#include "scenario/setup/TimeSchemes.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>

// Rate problems whose solution v is known: friction in steady state at v, alpha = ln(V* / V), and
// the right side b = Z v + gradient of friction. The slip rates are those of an earthquake cycle,
// as smooth as the weakening core of BP5 allows, so that all meshes resolve them.
namespace asperity::performance
{
namespace
{
enum class Phase
{
  stuck,      // V* / 1000 everywhere
  nucleating, // a patch half as long as the core slips at up to 10 mm/s
  rupturing   // the middle of the core slips at 1 m/s, a wide front reaches its ends
};

constexpr double reference = 1e-6;          // V* [m/s]
constexpr double slow = 1e-3 * reference;   // m/s
constexpr double fast = 1;                  // m/s
constexpr double size = 30e3, depth = 10e3; // half length and depth of the core [m]

// Along x, and decaying into the body.
double slipRate(Phase phase, Point<3> const& x)
{
  const double distance = std::hypot(x[0], x[1] + depth) / size;
  switch (phase) {
  case Phase::stuck: return slow;
  case Phase::nucleating:
    return slow * std::exp(std::log(0.01 * fast / slow) * std::exp(-std::pow(distance / 0.5, 2)));
  case Phase::rupturing: {
    const double behind = std::min(1., std::max(0., (1 - distance) / 0.8));
    return slow * std::exp(std::log(fast / slow) * behind);
  }
  }
  return 0;
}

struct Solved
{
  tnnmg::TnnmgResult result;
  double error = 0; // of v: the largest over the largest v
};

Solved solve(scenario::Problem<3> const& problem, Phase phase, CrsMatrix const& Z,
             dynamics::RateSolver& solver)
{
  auto const& body = problem.model.body;
  auto const known = body.vector(), b = body.vector(), zero = body.vector(), v = body.vector();
  {
    auto const values = known->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < problem.mesh().num_owned; ++node) {
      auto const& x = problem.mesh().vertices[node];
      const Point<3> along_axes = {
        slipRate(phase, x) / problem.surface().slipFactor() * std::exp(-x[2] / size), 0, 0};
      Point<3> local;
      problem.discretisation.frames().toFrame(node, along_axes.data(), local.data());
      for (int c = 0; c < 3; ++c) {
        values(body.dofs->dof(node, c), 0) = local[c];
      }
    }
  }
  body.clearHeld(*known);
  std::vector<double> alpha;
  for (auto const& node : problem.surface()) {
    alpha.push_back(std::log(reference / slipRate(phase, node.place)));
  }
  const dynamics::FrictionProblem friction{
    problem.model.fault.friction(), {toDevice(alpha, "alpha"), problem.model.initial.sigma_n}};
  Z.apply(*known, *b);
  addFrictionForces(problem.surface(), friction, *known, *b);
  body.clearHeld(*b);
  solver.begin(*b, *zero); // from rest
  Solved solved;
  solved.result = solver.solve(friction);
  solver.velocity(*v);
  v->update(-1, *known, 1);
  solved.error = v->normInf() / known->normInf();
  return solved;
}

// The three phases with steps of 1e5 and 1 s on the fault's cells of cell_size times 2 km, where Z
// does not couple the fault's tangents and a hierarchy has to be rebuilt for friction all the same.
std::vector<Solved> solveAll(int cell_size, std::string const& correction_tolerance,
                             RCP<const Communicator> const& communicator)
{
  auto const deck = bp5(cell_size, {"TNNMG/Multigrid/Hierarchy=Rebuild",
                                    "TNNMG/Correction Tolerance=" + correction_tolerance});
  auto const problem = scenario::makeProblem<3>(*deck, communicator);
  auto const update = scenario::makeRateUpdate(problem.settings.time, false);
  std::vector<Solved> all;
  for (double tau : {1e5, 1.}) {
    auto const Z =
      fem::combine(problem.model.body.matrices, update.weights(tau, problem.model.body.matrices),
                   problem.model.body.held);
    auto const solver =
      dynamics::makeRateSolver(Z, problem.model.body, problem.surface(), problem.solver);
    for (auto phase : {Phase::stuck, Phase::nucleating, Phase::rupturing}) {
      all.push_back(solve(problem, phase, *Z, *solver));
    }
  }
  return all;
}
} // namespace

TEST(RateProblems, AreSolvedByTheKnownSolutions)
{
  for (int cell_size : {8, 4}) {
    for (auto const& solved : solveAll(cell_size, "0.1", Tpetra::getDefaultComm())) {
      EXPECT_TRUE(solved.result.converged);
      EXPECT_LT(solved.error, 1e-4) << "ten times the deck's relative tolerance";
      EXPECT_GT(solved.result.v_cycles, 0);
    }
  }
}

// Gauss-Seidel is local to a rank, so what a loose correction leaves depends on the ranks, and from
// rest a rupture is then reached on other ways: compared with tight ones.
TEST(RateProblems, TakeAsManyIterationsOnMoreRanks)
{
  auto const world = Tpetra::getDefaultComm();
  auto const alone = world->split(world->getRank(), 0);
  for (int cell_size : {8, 4}) {
    auto const together = solveAll(cell_size, "1e-4", world);
    auto const one_by_one = solveAll(cell_size, "1e-4", alone);
    for (std::size_t i = 0; i < together.size(); ++i) {
      EXPECT_NEAR(together[i].result.iterations, one_by_one[i].result.iterations, 1) << i;
      EXPECT_LT(together[i].error, 1e-4);
    }
  }
}
} // namespace asperity::performance
