#include "dynamics/CoupledStep.hpp"

#include "base/Parameters.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <cmath>

namespace asperity::dynamics
{
Teuchos::RCP<Teuchos::ParameterList> CouplingSettings::validParameters()
{
  const CouplingSettings defaults;
  return Declare()
    .real("Tolerance", defaults.tolerance, "-", Range::positive(),
          "Change of alpha between two fixed point iterates, as root mean square over the fault, "
          "at which the "
          "coupling of rate and state counts as resolved.")
    .integer("Maximum Iterations", defaults.max_iterations, Range::atLeast(1),
             "Fixed point iterations after which the step is rejected and halved.")
    .real("lambda", defaults.lambda, "-", Range::closed(0, 1),
          "The state sees the velocity lambda v0 + (1 - lambda) v1 over a step (thesis eq. 25).")
    .list();
}

CouplingSettings CouplingSettings::from(Teuchos::ParameterList const& parameters)
{
  CouplingSettings settings;
  settings.tolerance = parameters.get<double>("Tolerance");
  settings.max_iterations = parameters.get<int>("Maximum Iterations");
  settings.lambda = parameters.get<double>("lambda");
  return settings;
}

void SolveCount::add(tnnmg::TnnmgResult const& result)
{
  ++rate_problems;
  tnnmg_iterations += result.iterations;
  corrections += result.corrections;
  correction_iterations += result.correction_iterations;
  v_cycles += result.v_cycles;
  rises += result.rises;
}

CoupledStep::CoupledStep(Body const& body, Fault const& fault, RateUpdate const& update,
                         DyadicTime const& clock, CouplingSettings const& settings,
                         StepSolvers& solvers)
    : body_(body)
    , fault_(fault)
    , update_(update)
    , clock_(clock)
    , settings_(settings)
    , solvers_(solvers)
    , b_(body.vector())
    , prescribed_(body.vector())
    , u_hat_(body.vector())
    , a_hat_(body.vector())
    , work_u_(body.vector())
    , work_a_(body.vector())
    , guess_(body.vector())
    , v0_("asperity::dynamics::v0", fault.numNodes(), fault.num_tangents)
    , v1_("asperity::dynamics::v1", fault.numNodes(), fault.num_tangents)
    , prescribed_blocks_("asperity::dynamics::prescribed", fault.numNodes(), fault.num_tangents)
    , V_("asperity::dynamics::V", fault.numNodes())
    , alpha_next_("asperity::dynamics::alphaNext", fault.numNodes())
{
}

// b = l(t1) + M a^ - K u^ - Z v_D on the free dofs, v_D the prescribed velocity: the rate problem
// is solved for w = v1 - v_D, which is zero at fixed dofs.
void CoupledStep::rightSide(State const& from, double t1, double tau)
{
  body_.prescribed_velocity(t1, *prescribed_);
  update_.predict(*from.u, *from.v, *from.a, tau, *u_hat_, *a_hat_);
  work_a_->update(1, *a_hat_, -update_.mass_weight / tau, *prescribed_, 0);
  work_u_->update(1, *u_hat_, tau * update_.stiffness_weight, *prescribed_, 0);
  body_.load(t1, *b_);
  body_.matrices.mass->apply(*work_a_, *b_, Teuchos::NO_TRANS, 1, 1);
  body_.matrices.viscosity->apply(*prescribed_, *b_, Teuchos::NO_TRANS, -1, 1);
  body_.matrices.stiffness->apply(*work_u_, *b_, Teuchos::NO_TRANS, -1, 1);
  body_.clearFixed(*b_);
}

CoupledResult CoupledStep::solve(State const& from, int level, State& to, SolveCount& count)
{
  const double tau = clock_.stepSize(level);
  to.time = from.time + clock_.ticks(level);
  rightSide(from, clock_.seconds(to.time), tau);

  guess_->update(1, *to.v, -1, *prescribed_, 0);
  body_.clearFixed(*guess_);
  auto& solver = solvers_.at(level);
  solver.begin(*b_, *guess_);
  fault_.gather(*from.v, v0_);
  fault_.gather(*prescribed_, prescribed_blocks_);

  auto const result = iterate(from, tau, solver, to, count);
  ++count.coupled_steps;
  if (!result.solved()) {
    ++count.failures;
    return result;
  }
  solver.velocity(*to.v);
  to.v->update(1, *prescribed_, 1);
  Tpetra::deep_copy(*to.u, *u_hat_);
  Tpetra::deep_copy(*to.a, *a_hat_);
  update_.complete(*to.v, tau, *to.u, *to.a);
  return result;
}

CoupledResult CoupledStep::iterate(State const& from, double tau, RateSolver& solver, State& to,
                                   SolveCount& count)
{
  CoupledResult result;
  while (result.iterations < settings_.max_iterations) {
    ++result.iterations;
    auto const rate = solver.solve({*fault_.friction, to.alpha});
    count.add(rate);
    if (!rate.converged) {
      result.status = StepStatus::rate_problem_failed;
      return result;
    }
    solver.faultVelocity(v1_);
    auto const v1 = v1_;
    auto const prescribed = prescribed_blocks_;
    const int size = fault_.num_tangents;
    Kokkos::parallel_for(
      "asperity::dynamics::addPrescribed",
      Kokkos::RangePolicy<friction::ExecutionSpace>(0, fault_.numNodes()), KOKKOS_LAMBDA(int node) {
        for (int k = 0; k < size; ++k) {
          v1(node, k) += prescribed(node, k);
        }
      });
    fault_.slipRate(v0_, v1_, settings_.lambda, V_);
    const int failed = fault_.sumOverRanks(fault_.state->flow(V_, tau, from.alpha, alpha_next_));
    const double change = fault_.distance(alpha_next_, to.alpha);
    if (failed > 0 || !std::isfinite(change)) {
      result.status = StepStatus::state_failed;
      return result;
    }
    Kokkos::deep_copy(to.alpha_of_rate, to.alpha);
    Kokkos::deep_copy(to.alpha, alpha_next_);
    if (change <= settings_.tolerance) {
      return result;
    }
  }
  result.status = StepStatus::fixed_point_failed;
  return result;
}
} // namespace asperity::dynamics
