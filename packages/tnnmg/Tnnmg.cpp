#include "tnnmg/Tnnmg.hpp"

#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"
#include "tnnmg/LineSearch.hpp"

#include <Tpetra_Map.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace asperity::tnnmg
{
Tnnmg::Tnnmg(std::shared_ptr<const RateMatrix> Z, std::shared_ptr<LinearCorrection> correction,
             TnnmgSettings const& settings)
    : Z_(std::move(Z))
    , correction_(std::move(correction))
    , settings_(settings)
    , vectors_(*Z_)
    , blocks_(Z_->nodes())
{
}

double Tnnmg::smallError(double norm) const
{
  return std::max(settings_.absolute_tolerance, settings_.relative_tolerance * norm);
}

// Changes of v fall as the error does: the slower of their last two falls counts, since nodes that
// begin to move or to rest make one slow. What the correction has left counts also where changes
// fall faster, as where the problem has changed between two iterations.
double Tnnmg::errorAfter(double change, double left)
{
  const double ratio = change / last_change_, ratio_before = std::exchange(last_ratio_, ratio);
  last_change_ = change;
  const double factor = std::max({left, ratio, ratio_before});
  constexpr double slow = 0.5;
  return factor < slow ? factor / (1 - factor) * change : change;
}

void Tnnmg::begin(Vector const& b, Vector const& guess)
{
  vectors_.begin(b, guess);
  gather(Z_->nodes().dofs, *vectors_.v, blocks_.v);
  has_residual_ = false;
  last_change_ = 0;
  last_ratio_ = std::numeric_limits<double>::infinity();
}

// A start beyond bounds has no finite J: its nearest point within them is the start.
void Tnnmg::takeBounds(NodalProblem const& problem)
{
  auto const bounds = problem.bounds();
  bounded_.reset();
  if (bounds.exist) {
    bounded_.emplace(Z_->nodes(), bounds);
    bounded_->moveIntoBounds(blocks_.v, *vectors_.v);
  }
}

void Tnnmg::computeResidual()
{
  Z_->residual(vectors_.b, *vectors_.v, vectors_.r);
  has_residual_ = true;
}

// The residual is computed anew, free of the rounding of earlier updates.
TnnmgResult Tnnmg::solve(NodalProblem const& problem)
{
  takeBounds(problem);
  computeResidual();
  return iterate(problem, settings_.max_iterations);
}

TnnmgResult Tnnmg::improve(NodalProblem const& problem)
{
  if (!has_residual_) {
    takeBounds(problem);
    computeResidual();
  }
  return iterate(problem, 1);
}

TnnmgResult Tnnmg::iterate(NodalProblem const& problem, int max_iterations)
{
  TnnmgResult result;
  int failed_here = 0; // on this rank
  while (result.iterations < max_iterations && !result.converged) {
    ++result.iterations;
    vectors_.beginIteration();
    failed_here += smooth(problem, result);
    remaining_share_ = 1;
    const bool corrected = findCorrection(problem, result) && searchAlong(problem, result);
    auto const norms = vectors_.norms(failed_here);
    result.last_change = norms.change;
    result.error = errorAfter(norms.change, remaining_share_);
    result.failed_nodes = norms.failed_nodes;
    // Without a correction, the last change says nothing about the dofs that Gauss-Seidel does not
    // visit.
    result.converged = corrected && result.error <= smallError(norms.v);
  }
  result.converged = result.converged && !result.failed();
  return result;
}

// Returns the number of nodes whose minimisation failed on this rank.
int Tnnmg::smooth(NodalProblem const& problem, TnnmgResult& result)
{
  ASPERITY_TIME_WORK("Gauss-Seidel sweeps");
  Kokkos::deep_copy(blocks_.before, blocks_.v);
  int failed_nodes = 0;
  for (int sweep = 0; sweep < settings_.sweeps; ++sweep) {
    failed_nodes +=
      Z_->sweep(problem, vectors_.b, *vectors_.v_columns, vectors_.r, blocks_.v, blocks_.residual);
  }
  blocks_.differenceTo(blocks_.before, blocks_.d);
  auto const nonlinear = problem.difference(blocks_.before, blocks_.d);
  Z_->finishSweeps(blocks_.d, vectors_.b, *vectors_.v, vectors_.r);
  result.energy_increases += vectors_.increasesInSweeps(*Z_, blocks_, nonlinear);
  return failed_nodes;
}

// False if the linear correction has not converged and is zero or not a number.
bool Tnnmg::findCorrection(NodalProblem const& problem, TnnmgResult& result)
{
  ASPERITY_TIME_WORK("linear corrections");
  problem.linearise(blocks_.v, blocks_.gradient, blocks_.hessian, blocks_.truncated);
  if (bounded_) {
    bounded_->truncate(blocks_, Z_->curvature(), settings_.stiff);
  } else {
    blocks_.truncate(Z_->nodes(), Z_->curvature(), settings_.stiff);
  }
  vectors_.newtonResidual(Z_->nodes(), blocks_.gradient);
  if (bounded_) {
    bounded_->clearFixed(vectors_.newton_residual);
  }
  auto const solved =
    correction_->solve({blocks_.hessian, blocks_.truncated}, vectors_.newton_residual,
                       settings_.correction_tolerance, vectors_.c);
  remaining_share_ = solved.converged ? settings_.correction_tolerance : 1;
  ++result.corrections;
  result.correction_iterations += solved.iterations;
  result.v_cycles += solved.v_cycles;
  if (!solved.converged && !(vectors_.c.norm2() > 0)) { // zero, or not a number
    ++result.failed_corrections;
    return false;
  }
  if (bounded_) {
    bounded_->clearFixed(vectors_.c);
  }
  return true;
}

// Shortens the correction such that it ends within the bounds. Returns the largest step along it
// that stays there, and all smaller ones do, since bounds are convex. The projection of v + c onto
// the bounds is nearer to the minimiser than a step that stops at the first bound, but J may rise
// towards it. Then the correction remains as it is, along which J falls.
double Tnnmg::confineCorrection(NodalProblem const& problem)
{
  auto const& communicator = *Z_->rows()->getComm();
  const Vector whole(vectors_.c, Teuchos::Copy);
  bounded_->project(blocks_.v, vectors_.c);
  gather(Z_->nodes().dofs, vectors_.c, blocks_.d);
  const double start =
    sumOverRanks(problem.slope(blocks_.v, blocks_.d, 0), communicator) - vectors_.r.dot(vectors_.c);
  if (start < 0) {
    return 1;
  }
  Tpetra::deep_copy(vectors_.c, whole);
  return minOverRanks(bounded_->largestStep(blocks_.v, vectors_.c), communicator);
}

// This rank's part of the change of psi along the correction, which blocks_.d holds.
EnergyChange Tnnmg::nonlinearChange(NodalProblem const& problem, double step) const
{
  blocks_.scaleChange(step);
  return problem.difference(blocks_.v, blocks_.scaled);
}

// False if J does not fall along the correction although the correction is too large to be ignored.
bool Tnnmg::searchAlong(NodalProblem const& problem, TnnmgResult& result)
{
  ASPERITY_TIME_WORK("line searches");
  const double largest_step = bounded_ ? confineCorrection(problem) : 1024;
  gather(Z_->nodes().dofs, vectors_.c, blocks_.d);
  auto const mine = vectors_.derivativeAlongCorrection(*Z_);
  auto const of_step = nonlinearChange(problem, 1);
  auto const& communicator = *Z_->rows()->getComm();
  // All that a step of one needs, which is the most frequent result, is summed over the ranks at
  // once.
  auto const sums = sumOverRanks(std::array<double, 7>{mine.start, mine.curvature, mine.magnitude,
                                                       problem.slope(blocks_.v, blocks_.d, 0),
                                                       problem.slope(blocks_.v, blocks_.d, 1),
                                                       of_step.change, of_step.magnitude},
                                 communicator);
  const detail::TnnmgVectors::Along along = {sums[0], sums[1], sums[2]};
  auto const slope = [&](double t) {
    const double of_nodes = t == 0 ? sums[3]
                            : t == 1
                              ? sums[4]
                              : sumOverRanks(problem.slope(blocks_.v, blocks_.d, t), communicator);
    return of_nodes + along.start + t * along.curvature;
  };
  auto const changeAlong = [&](double t) {
    EnergyChange nonlinear = {sums[5], sums[6]};
    if (t != 1) {
      auto const here = nonlinearChange(problem, t);
      auto const all =
        sumOverRanks(std::array<double, 2>{here.change, here.magnitude}, communicator);
      nonlinear = {all[0], all[1]};
    }
    return EnergyChange{t * (along.start + t / 2 * along.curvature) + nonlinear.change,
                        t * (along.magnitude + t / 2 * along.curvature) + nonlinear.magnitude};
  };
  const double start = slope(0);
  double step = findSignChange(slope, start, 1e-2, largest_step);
  auto change = changeAlong(step);
  if (change.change > 0 && step > 0) {
    // The slope at this step was small but positive. Where the slope is not positive, J is certain
    // to be below its start.
    step = findSignChange(slope, start, 0., largest_step);
    change = changeAlong(step);
  }
  if (!(step > 0) && !(std::sqrt(along.curvature) <= smallError(vectors_.norms(0).v))) {
    ++result.failed_corrections;
    return false;
  }
  auto const num_rows = static_cast<double>(Z_->rows()->getGlobalNumElements());
  if (change.countsAsIncrease(num_rows) != 0) { // by the estimated magnitude
    const double terms = vectors_.magnitudeOfTerms(*Z_, *vectors_.v, vectors_.r, vectors_.c);
    change.magnitude += step * (sumOverRanks(terms, communicator) - along.magnitude);
    result.energy_increases += change.countsAsIncrease(num_rows);
  }
  remaining_share_ = std::max(remaining_share_, std::fabs(1 - step));
  vectors_.move(step);
  gather(Z_->nodes().dofs, *vectors_.v, blocks_.v);
  if (bounded_) {
    bounded_->moveIntoBounds(blocks_.v, *vectors_.v); // which rounding may have passed
  }
  return true;
}
} // namespace asperity::tnnmg
