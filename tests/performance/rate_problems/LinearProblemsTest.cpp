#include "dynamics/coupling/CoupledStep.hpp"
#include "fem/BodyMatrices.hpp"
#include "performance/rate_problems/Bp5.hpp"
#include "scenario/setup/TimeSchemes.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>

// What friction costs: a step of a run, its rate problem, and the linear problem with the same
// matrix, solution, guess and error.
namespace asperity::performance
{
namespace
{
double energyNorm(CrsMatrix const& Z, Vector const& x)
{
  Vector image(x.getMap());
  Z.apply(x, image);
  return std::sqrt(std::max(image.dot(x), 0.));
}

// Smoothed aggregation as MueLu has it: symmetric Gauss-Seidel before and after. For one rank:
// its direct coarse solver gives wrong results on more.
class Aggregation
{
public:
  Aggregation(RCP<const CrsMatrix> const& Z, dynamics::Body const& body) : Z_(Z)
  {
    auto const motions = rcp(new MultiVector(*body.near_null_space, Teuchos::Copy));
    {
      auto const values = motions->getLocalViewHost(Tpetra::Access::ReadWrite);
      auto const held =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body.held.ownedOnDevice());
      for (int k = 0; k < held.extent_int(0); ++k) {
        for (int column = 0; column < values.extent_int(1); ++column) {
          values(held(k), column) *= 1e-8; // MueLu refuses all 0 on an aggregate
        }
      }
    }
    Teuchos::ParameterList list("MueLu");
    list.set("verbosity", "none");
    list.set("number of equations", body.dofs->components());
    list.set("rap: fix zero diagonals", true);
    list.sublist("user data").set("Nullspace", motions);
    const RCP<Operator> fine = Teuchos::rcp_const_cast<CrsMatrix>(Z);
    preconditioner_ = MueLu::CreateTpetraPreconditioner(fine, list);
  }

  // The iterations of conjugate gradients, each with a V-cycle, from zero until the energy norm of
  // the error is at most `error`.
  int cyclesFor(Vector const& solution, double error) const
  {
    auto const map = solution.getMap();
    Vector left(solution, Teuchos::Copy), r(map), z(map), p(map), image(map);
    Z_->apply(solution, r);
    double rz = 0;
    int cycles = 0;
    for (; energyNorm(*Z_, left) > error && cycles < 200; ++cycles) {
      preconditioner_->apply(r, z);
      const double before = rz;
      rz = r.dot(z);
      p.update(1, z, cycles == 0 ? 0 : rz / before);
      Z_->apply(p, image);
      const double length = rz / p.dot(image);
      left.update(-length, p, 1);
      r.update(-length, image, 1);
    }
    return cycles;
  }

private:
  using Operator = Tpetra::Operator<double, LocalOrdinal, GlobalOrdinal>;
  RCP<const CrsMatrix> Z_;
  RCP<Operator> preconditioner_;
};
} // namespace

TEST(RateProblems, TakeHardlyMoreCyclesThanLinearOnes)
{
  // 1. The steps of a run, and solvers of their own for rate problems.
  auto const deck = bp5(2);
  auto const problem = scenario::makeProblem<3>(*deck, Tpetra::getDefaultComm());
  auto const& time = problem.settings.time;
  auto const update = scenario::makeRateUpdate(time, false);
  auto const clock = scenario::makeClock(time);
  const auto budget = problem.settings.solver.memoryBudget();
  dynamics::CoupledStep step(problem.model.body, problem.model.fault,
                             {update, clock,
                              dynamics::CouplingSettings::from(deck->sublist("Coupling"), 0),
                              problem.solver, budget});
  auto const control = scenario::makeStepControl(time, {}, step);
  dynamics::StepSolvers solvers(problem.model.body, problem.surface(), update, clock,
                                problem.solver, budget);
  auto state = problem.model.initial.clone();
  dynamics::SolveCount of_run, coupled;
  std::int64_t rate_cycles = 0, linear_cycles = 0;
  for (int i = 0; i < 4; ++i) {
    // 2. One more step of the size of the last one, with a guess from the last two states.
    auto const before = state.clone();
    const int level = control->advance(state, of_run).level;
    const double ratio =
      static_cast<double>(clock.ticks(level)) / static_cast<double>(state.time - before.time);
    auto const guess = dynamics::blend({1 + ratio, state, before});
    auto end = guess.clone();
    ASSERT_TRUE(step.solve(state, level, end, coupled).solved());
    // 3. The rate problem at its end, with the right side of which its velocity is the solution.
    const double tau = clock.stepSize(level);
    auto const Z =
      fem::combine(problem.model.body.matrices, update.weights(tau, problem.model.body.matrices),
                   problem.model.body.held);
    auto const solution = problem.model.body.vector(), b = problem.model.body.vector(),
               start = problem.model.body.vector(), w = problem.model.body.vector();
    problem.model.body.prescribed_velocity(clock.seconds(end.time), *w);
    solution->update(1, *end.v, -1, *w, 0);
    start->update(1, *guess.v, -1, *w, 0);
    problem.model.body.clearHeld(*solution);
    problem.model.body.clearHeld(*start);
    const dynamics::FrictionProblem friction{problem.model.fault.friction(),
                                             {end.alpha_of_rate, end.sigma_n}};
    Z->apply(*solution, *b);
    addFrictionForces(problem.surface(), friction, *solution, *b);
    problem.model.body.clearHeld(*b);
    auto& solver = solvers.at(level);
    solver.begin(*b, *start);
    auto const result = solver.solve(friction);
    ASSERT_TRUE(result.converged);
    rate_cycles += result.v_cycles;
    solver.velocity(*w);
    w->update(-1, *solution, 1);
    const double error = energyNorm(*Z, *w);
    EXPECT_LT(error, 1e-5 * energyNorm(*Z, *solution)) << "the deck's relative tolerance";
    // 4. The linear problem.
    solution->update(-1, *start, 1);
    linear_cycles += Aggregation(Z, problem.model.body).cyclesFor(*solution, error);
  }
  RecordProperty("coupled, rate and linear cycles", std::to_string(coupled.v_cycles) + ", " +
                                                      std::to_string(rate_cycles) + ", " +
                                                      std::to_string(linear_cycles));
  EXPECT_GT(linear_cycles, 0);
  EXPECT_LT(rate_cycles, 2 * linear_cycles);
  EXPECT_LT(static_cast<double>(coupled.v_cycles), 1.7 * static_cast<double>(rate_cycles));
}
} // namespace asperity::performance
