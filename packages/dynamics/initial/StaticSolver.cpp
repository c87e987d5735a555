#include "dynamics/initial/StaticSolver.hpp"

#include "base/Errors.hpp"
#include "dynamics/rate/SharedMultigrid.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <sstream>
#include <utility>

namespace asperity::dynamics
{
namespace
{
// With rounding even a singular matrix may have a factor; then u is not a solution.
void requireSolution(CrsMatrix const& K, Vector const& b, Vector const& u)
{
  Vector rest(b, Teuchos::Copy);
  K.apply(u, rest, Teuchos::NO_TRANS, -1, 1);
  if (!(rest.norm2() <= 1e-6 * b.norm2())) {
    throw SolveError("The static problem has no solution: some part of the body can move without "
                     "resistance, or its numbers are too large to compute with. Check that the "
                     "boundary conditions hold it, that the moduli, viscosities and density in "
                     "Bulk are in SI units, and that Poisson's Ratio is not close to 0.5.");
  }
}

std::unique_ptr<tnnmg::MultigridCorrection> makeMultigrid(RCP<const CrsMatrix> const& K,
                                                          Body const& body,
                                                          Teuchos::ParameterList const& parameters)
{
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> none(
    "asperity::dynamics::none", 0, 1);
  Teuchos::ParameterList list(parameters);
  list.set("Method", "CG");      // a few cycles would not meet the tolerance
  list.set("Hierarchy", "Keep"); // without friction there are no Hessians
  return std::make_unique<tnnmg::MultigridCorrection>(
    multigridProblem(K, body, {none, body.held.flagsOnDevice(), {}}), list);
}
} // namespace

StaticSolver::StaticSolver(Body body, RateSolverSettings const& settings)
    : body_(std::move(body))
    , K_(fem::combine(body_.matrices, fem::elasticityWeights(body_.matrices), body_.held))
{
  if (settings.correction == Correction::direct) {
    factor_ = std::make_unique<tnnmg::SchurComplement>(*K_, std::vector<int>());
  } else {
    multigrid_ = makeMultigrid(K_, body_, settings.multigrid);
  }
}

StaticSolver::~StaticSolver() = default;

RCP<Vector> StaticSolver::solve(Vector const& load)
{
  Vector b(load, Teuchos::Copy);
  body_.clearHeld(b);
  auto u = body_.vector();
  if (factor_) {
    factor_->condense(b).expand(Vector(factor_->map()), *u);
    requireSolution(*K_, b, *u);
    return u;
  }
  auto const result = multigrid_->solve({}, b, 1e-12, *u); // the residual over |b|
  if (!result.converged) {
    std::ostringstream message;
    message << "The static problem was not solved: conjugate gradients stopped after "
            << result.iterations
            << " iterations. Check that the boundary conditions hold the body, "
            << "and raise the iteration limit in TNNMG / Multigrid.";
    throw SolveError(message.str());
  }
  return u;
}
} // namespace asperity::dynamics
