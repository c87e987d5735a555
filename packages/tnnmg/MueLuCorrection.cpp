#include "tnnmg/MueLuCorrection.hpp"

#include "tnnmg/detail/MultigridConjugateGradients.hpp"
#include "tnnmg/detail/MultigridParameters.hpp"
#include "tnnmg/detail/MultigridPreconditioner.hpp"
#include "tnnmg/detail/MultigridSymmetry.hpp"
#include "tnnmg/detail/MultigridTrial.hpp"

#include <Teuchos_TimeMonitor.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::tnnmg
{
namespace
{
// Held rows are decoupled and their residuals are zero, so their entries of the near null
// space have no effect. The entries are made small but not zero, because MueLu refuses an aggregate
// on which a vector vanishes, as between the nodes of a wall.
RCP<const MultiVector> withTraceAt(MultiVector const& vectors, IndexView const& rows)
{
  constexpr double trace = 1e-8;
  const auto result = rcp(new MultiVector(vectors, Teuchos::Copy));
  const auto values = result->getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::tnnmg::withTraceAt", Kokkos::RangePolicy<ExecutionSpace>(0, rows.extent_int(0)),
    KOKKOS_LAMBDA(int k) {
      for (int column = 0; column < values.extent_int(1); ++column) {
        values(rows(k), column) *= trace;
      }
    });
  return result;
}

// Steepest descent with the preconditioner's direction: the energy decreases in every cycle, even
// where a step of length one would overshoot.
detail::IterationResult descend(detail::Operator const& A, detail::Operator const& B,
                                Vector const& r, double relative_tolerance, int num_cycles,
                                Vector& c)
{
  detail::IterationResult result;
  Vector residual(r, Teuchos::Copy);
  Vector direction(r.getMap());
  Vector image(r.getMap());
  const double target = relative_tolerance * r.norm2();
  c.putScalar(0);
  result.converged = r.norm2() <= target;
  while (!result.converged && result.iterations < num_cycles) {
    B.apply(residual, direction);
    A.apply(direction, image);
    const double step = residual.dot(direction) / direction.dot(image);
    c.update(step, direction, 1);
    residual.update(-step, image, 1);
    ++result.iterations;
    result.converged = residual.norm2() <= target;
  }
  return result;
}
} // namespace

struct MueLuCorrection::Implementation
{
  using Parameters = detail::MultigridParameters;

  Implementation(MultigridProblem const& problem, Parameters const& values,
                 std::shared_ptr<const detail::MultigridFamily> const& family,
                 std::vector<double> const& weights)
      : parameters(values)
      , nodes(std::make_shared<detail::MultigridNodes>(
          detail::makeNodes(*problem.Z, problem.nodes, problem.held_rows)))
      , A(rcp(new detail::MultigridOperator(problem.Z, nodes)))
      , residual(problem.Z->getRowMap())
  {
    Teuchos::TimeMonitor const timed(setup_timer);
    preconditioner = rcp(new detail::MultigridPreconditioner(family, weights, problem.Z, nodes));
    // The asymmetry is relative to the energy of pseudorandom vectors. Since this energy is small
    // compared with their squares, by the square root of Z's condition number, rounding to single
    // precision shows. A defect, for example of a direct solver, gives an asymmetry of order one.
    detail::requireSymmetric(*preconditioner, *nodes, 1e-3);
  }

  void prepare(NonlinearBlocks const& blocks)
  {
    Teuchos::TimeMonitor const timed(setup_timer);
    nodes->set(blocks);
    if (parameters.rebuilds && preconditioner->outdatedShare() > parameters.outdated_share) {
      preconditioner->rebuild();
      ++statistics.rebuilds;
    } else {
      preconditioner->setup();
    }
  }

  detail::IterationResult iterate(double relative_tolerance, Vector& c)
  {
    if (parameters.method == Parameters::Method::v_cycles) {
      return descend(*A, *preconditioner, residual, relative_tolerance, parameters.v_cycles, c);
    }
    if (relative_tolerance >= detail::SingleGradients::certain) {
      return preconditioner->solveLoosely(residual, relative_tolerance, parameters.max_iterations,
                                          c);
    }
    return detail::conjugateGradients(A, preconditioner, residual, relative_tolerance,
                                      parameters.max_iterations, parameters.belos, c);
  }

  Parameters parameters;
  std::shared_ptr<detail::MultigridNodes> nodes;
  RCP<const detail::MultigridOperator> A;
  RCP<detail::MultigridPreconditioner> preconditioner;
  Vector residual;
  Teuchos::Time setup_timer{"set-up of a correction"};
  MultigridStatistics statistics;
};

Teuchos::RCP<const Teuchos::ParameterList> MueLuCorrection::validParameters()
{
  return detail::MultigridParameters::valid();
}

void MueLuCorrection::requireAccepted(Teuchos::ParameterList const& parameters)
{
  detail::tryParameters(parameters);
}

MultigridTerms::MultigridTerms(std::vector<MatrixSource> const& terms, MultigridProblem const& like,
                               Teuchos::ParameterList const& parameters)
    : family_(std::make_shared<detail::MultigridFamily>(
        terms, like.components, withTraceAt(*like.near_null_space, like.held_rows), like.nodes.dofs,
        detail::MultigridParameters(parameters, like.components).aggregation))
{
}

std::size_t MultigridTerms::bytes() const { return family_ ? family_->bytes() : 0; }

MueLuCorrection::MueLuCorrection(MultigridProblem const& problem,
                                 Teuchos::ParameterList const& parameters,
                                 MultigridTerms const& terms, std::vector<double> const& weights)
{
  const detail::MultigridParameters values(parameters, problem.components);
  implementation_ =
    terms.empty()
      ? std::make_unique<Implementation>(
          problem, values, MultigridTerms({[&] { return problem.Z; }}, problem, parameters).family_,
          std::vector<double>{1})
      : std::make_unique<Implementation>(problem, values, terms.family_, weights);
}

MueLuCorrection::~MueLuCorrection() = default;

CorrectionResult MueLuCorrection::solve(NonlinearBlocks const& blocks, Vector const& r,
                                        double relative_tolerance, Vector& c)
{
  auto& self = *implementation_;
  self.prepare(blocks);
  self.residual.assign(r);
  self.nodes->project(self.residual);
  const int cycles_before = self.preconditioner->numCycles();
  const auto outcome = self.iterate(relative_tolerance, c);
  self.nodes->project(c);

  CorrectionResult result;
  result.converged = outcome.converged;
  result.iterations = outcome.iterations;
  result.v_cycles = self.preconditioner->numCycles() - cycles_before;
  ++self.statistics.solves;
  self.statistics.iterations += result.iterations;
  self.statistics.v_cycles += result.v_cycles;
  return result;
}

void MueLuCorrection::reset() { implementation_->preconditioner->forgetHessians(); }

std::size_t MueLuCorrection::bytes() const { return implementation_->preconditioner->bytes(); }

MultigridStatistics MueLuCorrection::statistics() const
{
  auto result = implementation_->statistics;
  result.setup_seconds = implementation_->setup_timer.totalElapsedTime();
  return result;
}
} // namespace asperity::tnnmg
