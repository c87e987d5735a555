#include "tnnmg/correction/BelosConjugateGradients.hpp"

#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
using Problem = Belos::LinearProblem<double, MultiVector, Operator>;
using Solver = Belos::PseudoBlockCGSolMgr<double, MultiVector, Operator>;

// In the last iteration, too, Belos preconditions the residual before it tests whether the residual
// is small enough, and then does not use the result. This class avoids that V-cycle.
class UntilSolved : public Operator
{
public:
  UntilSolved(RCP<const Operator> preconditioner, double target)
      : preconditioner_(std::move(preconditioner))
      , target_(target)
  {
  }

  RCP<const Map> getDomainMap() const override { return preconditioner_->getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return preconditioner_->getRangeMap(); }

  void apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp, double, double) const override
  {
    if (r.getVector(0)->norm2() <= target_) {
      Tpetra::deep_copy(z, r);
    } else {
      preconditioner_->apply(r, z);
    }
  }

private:
  RCP<const Operator> preconditioner_;
  double target_;
};

// Belos throws if rounding has made the preconditioner indefinite; this counts as no convergence.
multigrid::IterationResult solveFromZero(RCP<Problem> const& problem,
                                         RCP<Teuchos::ParameterList> const& parameters)
{
  Solver solver(problem, parameters);
  multigrid::IterationResult result;
  try {
    result.converged = solver.solve() == Belos::Converged;
  } catch (Belos::BelosError const&) {
  }
  result.iterations = solver.getNumIters();
  return result;
}
} // namespace

void checkBelosParameters(Teuchos::ParameterList const& belos)
{
  belos.validateParameters(*Solver().getValidParameters());
}

multigrid::IterationResult conjugateGradients(RCP<const Operator> const& A,
                                              RCP<const Operator> const& preconditioner,
                                              Vector const& r, double relative_tolerance,
                                              int max_iterations,
                                              Teuchos::ParameterList const& belos, Vector& c)
{
  multigrid::IterationResult result;
  const double target = relative_tolerance * r.norm2();
  c.putScalar(0);
  const RCP<Vector> residual = rcp(new Vector(r, Teuchos::Copy));
  const RCP<Vector> correction = rcp(new Vector(r.getMap()));
  double norm = r.norm2();
  double before = 2 * norm;
  // If a restart does not halve the residual, rounding does not allow more.
  while (norm > target && result.iterations < max_iterations && norm <= 0.5 * before) {
    correction->putScalar(0);
    const auto problem = rcp(new Problem(A, correction, residual));
    // The tolerance is just below the one at which Belos has to stop, too.
    const RCP<const Operator> until_solved =
      rcp(new UntilSolved(preconditioner, (1 - 1e-10) * std::min(target, 0.9 * norm)));
    problem->setRightPrec(until_solved); // a left preconditioner is applied once more than needed
    problem->setProblem();
    const auto parameters = rcp(new Teuchos::ParameterList(belos));
    parameters->set("Convergence Tolerance", std::min(0.9, target / norm));
    parameters->set("Maximum Iterations", max_iterations - result.iterations);
    const auto solved = solveFromZero(problem, parameters);
    result.iterations += solved.iterations;
    c.update(1, *correction, 1);
    A->apply(c, *residual);
    residual->update(1, r, -1);
    before = norm;
    norm = residual->norm2();
  }
  result.converged = norm <= target;
  return result;
}
} // namespace asperity::tnnmg::detail
