#include "tnnmg/detail/MultigridConjugateGradients.hpp"

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

// Belos preconditions also the residual of the last iteration before it looks whether that is small
// enough, and then has no use for the answer: one V-cycle of three to six.
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

// Belos throws where the preconditioner has lost its definiteness to rounding: no convergence,
// then.
int solveFromZero(RCP<Problem> const& problem, RCP<Teuchos::ParameterList> const& parameters)
{
  Solver solver(problem, parameters);
  try {
    solver.solve();
  } catch (Belos::BelosError const&) {
  }
  return solver.getNumIters();
}
} // namespace

IterationResult conjugateGradients(RCP<const Operator> A, RCP<const Operator> preconditioner,
                                   Vector const& r, double relative_tolerance, int max_iterations,
                                   Teuchos::ParameterList const& belos, Vector& c)
{
  IterationResult result;
  const double target = relative_tolerance * r.norm2();
  c.putScalar(0);
  const RCP<Vector> residual = rcp(new Vector(r, Teuchos::Copy));
  const RCP<Vector> correction = rcp(new Vector(r.getMap()));
  double norm = r.norm2();
  double before = 2 * norm;
  // A restart that does not halve the residual has met the limit of rounding.
  while (norm > target && result.iterations < max_iterations && norm <= 0.5 * before) {
    correction->putScalar(0);
    const auto problem = rcp(new Problem(A, correction, residual));
    // Just below what Belos, too, has to find small enough.
    const RCP<const Operator> until_solved =
      rcp(new UntilSolved(preconditioner, (1 - 1e-10) * std::min(target, 0.9 * norm)));
    problem->setRightPrec(until_solved); // a left one is applied once more than needed
    problem->setProblem();
    const auto parameters = rcp(new Teuchos::ParameterList(belos));
    parameters->set("Convergence Tolerance", std::min(0.9, target / norm));
    parameters->set("Maximum Iterations", max_iterations - result.iterations);
    result.iterations += solveFromZero(problem, parameters);
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
