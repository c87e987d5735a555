#include "tnnmg/correction/MultigridCorrection.hpp"

#include "tnnmg/correction/BelosConjugateGradients.hpp"
#include "tnnmg/correction/MueLuPreconditioner.hpp"
#include "tnnmg/correction/MultigridParameters.hpp"
#include "tnnmg/correction/MultigridSymmetry.hpp"
#include "tnnmg/correction/OwnPreconditioner.hpp"

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
RCP<const MultiVector> scaledAt(MultiVector const& vectors, IndexView const& rows)
{
  constexpr double factor = 1e-8;
  const auto result = rcp(new MultiVector(vectors, Teuchos::Copy));
  const auto values = result->getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::tnnmg::scaledAt", RangePolicy(0, rows.extent_int(0)), KOKKOS_LAMBDA(int k) {
      for (int column = 0; column < values.extent_int(1); ++column) {
        values(rows(k), column) *= factor;
      }
    });
  return result;
}

// Steepest descent with the preconditioner's direction: the energy decreases in every cycle, even
// where a step of length one would overshoot.
multigrid::IterationResult descend(detail::Operator const& A, detail::Operator const& B,
                                   Vector const& r, double relative_tolerance, int num_cycles,
                                   Vector& c)
{
  multigrid::IterationResult result;
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

struct MultigridCorrection::Implementation
{
  using Parameters = detail::MultigridParameters;

  Implementation(MultigridProblem const& problem, Parameters const& values,
                 detail::MultigridHierarchy const& hierarchy, std::vector<double> const& weights)
      : parameters(values)
      , nodes(std::make_shared<detail::MultigridNodes>(
          detail::makeNodes(*problem.Z, problem.nodes, problem.held_rows)))
      , A(rcp(new detail::MultigridOperator(problem.Z, nodes)))
      , residual(problem.Z->getRowMap())
  {
    if (parameters.cycle == Parameters::CycleKind::asperity) {
      own_preconditioner = rcp(
        new detail::OwnPreconditioner(hierarchy, weights, problem.Z, nodes, parameters.smoother));
      preconditioner = own_preconditioner;
    } else {
      preconditioner = rcp(new detail::MueLuPreconditioner(
        hierarchy.prolongators(), parameters.muelu_cycle, problem.Z, nodes));
    }
    // The asymmetry is relative to the energy of pseudorandom vectors. Since this energy is small
    // compared with their squares, by the square root of Z's condition number, rounding to single
    // precision shows. A defect, for example of a direct solver, gives an asymmetry of order one.
    detail::requireSymmetric(*preconditioner, *nodes, 1e-3);
  }

  void prepare(NonlinearBlocks const& blocks)
  {
    nodes->set(blocks);
    if (parameters.rebuilds && preconditioner->outdatedShare() > parameters.outdated_share) {
      preconditioner->rebuild();
      ++rebuilds;
    } else {
      preconditioner->setup();
    }
  }

  multigrid::IterationResult iterate(double relative_tolerance, Vector& c)
  {
    if (parameters.method == Parameters::Method::v_cycles) {
      return descend(*A, *preconditioner, residual, relative_tolerance, parameters.v_cycles, c);
    }
    if (!own_preconditioner.is_null() &&
        relative_tolerance >= multigrid::FloatConjugateGradients::smallest_tolerance) {
      return own_preconditioner->solveInSinglePrecision(residual, relative_tolerance,
                                                        parameters.max_iterations, c);
    }
    return detail::conjugateGradients(A, preconditioner, residual, relative_tolerance,
                                      parameters.max_iterations, parameters.belos, c);
  }

  Parameters parameters;
  std::shared_ptr<detail::MultigridNodes> nodes;
  RCP<const detail::MultigridOperator> A;
  RCP<detail::Preconditioner> preconditioner;
  RCP<detail::OwnPreconditioner> own_preconditioner; // the same, unless the cycle is MueLu's
  Vector residual;
  int rebuilds = 0;
};

Teuchos::RCP<const Teuchos::ParameterList> MultigridCorrection::validParameters()
{
  return detail::MultigridParameters::valid();
}

MultigridTerms::MultigridTerms(std::vector<MatrixSource> const& terms, MultigridProblem const& like,
                               Teuchos::ParameterList const& parameters)
    : hierarchy_(std::make_shared<detail::MultigridHierarchy>(
        terms, like.components, scaledAt(*like.near_null_space, like.held_rows), like.nodes.dofs,
        detail::MultigridParameters::from(parameters, like.components).aggregation))
{
}

MultigridCorrection::MultigridCorrection(MultigridProblem const& problem,
                                         Teuchos::ParameterList const& parameters,
                                         MultigridTerms const& terms,
                                         std::vector<double> const& weights)
{
  auto const values = detail::MultigridParameters::from(parameters, problem.components);
  auto const own =
    terms.empty() ? MultigridTerms({[&] { return problem.Z; }}, problem, parameters) : terms;
  implementation_ = std::make_unique<Implementation>(
    problem, values, own.hierarchy(), terms.empty() ? std::vector<double>{1} : weights);
}

MultigridCorrection::~MultigridCorrection() = default;

CorrectionResult MultigridCorrection::solve(NonlinearBlocks const& blocks, Vector const& r,
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
  return result;
}

void MultigridCorrection::reset() { implementation_->preconditioner->forgetHessians(); }

std::size_t MultigridCorrection::bytes() const { return implementation_->preconditioner->bytes(); }

int MultigridCorrection::rebuilds() const { return implementation_->rebuilds; }
} // namespace asperity::tnnmg
