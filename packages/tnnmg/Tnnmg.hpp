#pragma once

#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"
#include "tnnmg/GaussSeidel.hpp"
#include "tnnmg/LineSearch.hpp"
#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/NonlinearNodes.hpp"
#include "tnnmg/TnnmgSettings.hpp"
#include "tnnmg/TnnmgVectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace asperity::tnnmg
{
struct TnnmgResult
{
  bool converged = false;
  int iterations = 0;
  int corrections = 0;
  int correction_iterations = 0; // of conjugate gradients
  int v_cycles = 0;
  int rises = 0;            // sweeps and corrections in which J grew by more than rounding
  int lost_corrections = 0; // corrections that were zero, or along which J did not fall
  double last_change = 0;   // energy norm
  int failed_nodes = 0;     // on any rank

  // True if more iterations would not help: a node failed, or a value is not finite.
  bool failed() const { return failed_nodes > 0 || !std::isfinite(last_change); }
};

// Truncated nonsmooth Newton multigrid (Graeser and Kornhuber 2009; Pipping 2014, ch. 4): minimises
//   J(v) = 1/2 <Z v, v> - <b, v> + sum over nonlinear nodes of psi_i(v_i),   psi_i convex,
// by iterations that each lower J: a nonlinear Gauss-Seidel sweep over the nonlinear nodes,
// truncation of the nodes where psi has no useful second derivative, a linear correction for all
// dofs, and a line search.
//
// NodalProblem (host object, its members launch kernels; views as in NonlinearNodes.hpp):
//   int minimise(IndexView nodes, ConstNodeView curvature, ConstBlockView r, BlockView v) const
//       v_i = argmin curvature_i/2 |w|^2 - <r_i, w> + psi_i(w) for the given nodes; returns the
//       number of nodes where this failed
//   int sweep(IndexView nodes, CoupledSystem const&, BlockView v) const
//       the same for the given nodes one after the other, with the force r_i + curvature_i v_i,
//       zero in held components, for r = b - Z v, which stays that; only for coupledNodes()
//   void linearise(ConstBlockView v, BlockView gradient, HessianView hessian, FlagView kinked)
//       const
//       of psi_i at v_i; kinked_i = 1 where psi_i has no second derivative
//   double slope(ConstBlockView v, ConstBlockView d, double t) const
//       sum of psi_i'(v_i + t d_i; d_i)
//   {double change, magnitude;} difference(ConstBlockView v, ConstBlockView d) const
//       sum of psi_i(v_i + d_i) - psi_i(v_i), accurate for small d, and the sum of the magnitudes
//       of its terms
template <class NodalProblem>
class Tnnmg
{
public:
  // Z is fill-complete; its column map starts with the owned rows, in the order of the domain map.
  Tnnmg(RCP<const CrsMatrix> const& Z, NonlinearNodes nodes,
        std::shared_ptr<LinearCorrection> correction, TnnmgSettings const& settings)
      : Z_(Z)
      , nodes_(std::move(nodes))
      , correction_(std::move(correction))
      , settings_(settings)
      , curvature_(nodalCurvature(*Z, nodes_))
      , vectors_(*Z, nodes_, *correction_)
      , blocks_(nodes_)
  {
  }

  // v holds the initial guess and is overwritten by the solution. b and v live on Z's domain map.
  // All ranks call it together.
  TnnmgResult solve(NodalProblem const& problem, Vector const& b, Vector& v)
  {
    return iterate(problem, b, v, settings_.max_iterations, false);
  }
  // Makes one iteration only, for problems that change before they need to be solved. continues: b
  // is that of the last call and v what it left; b - Z v is then known and saves a product.
  TnnmgResult improve(NodalProblem const& problem, Vector const& b, Vector& v,
                      bool continues = false)
  {
    return iterate(problem, b, v, 1, continues);
  }

private:
  TnnmgResult iterate(NodalProblem const& problem, Vector const& b, Vector& v, int max_iterations,
                      bool continues);
  int smooth(NodalProblem const& problem, Vector const& b, TnnmgResult& result);
  bool correct(NodalProblem const& problem, Vector const& b, TnnmgResult& result);
  bool findCorrection(NodalProblem const& problem, TnnmgResult& result);
  bool searchAlong(NodalProblem const& problem, Vector const& b, TnnmgResult& result);
  // The largest change that counts as converged, in the energy norm; norm: that of v.
  double smallChange(double norm) const
  {
    return std::max(settings_.absolute_tolerance, settings_.relative_tolerance * norm);
  }

  RCP<const CrsMatrix> Z_;
  NonlinearNodes nodes_;
  std::shared_ptr<LinearCorrection> correction_;
  TnnmgSettings settings_;
  NodeView curvature_;
  detail::TnnmgVectors vectors_;
  detail::TnnmgBlocks blocks_;
};

template <class NodalProblem>
TnnmgResult Tnnmg<NodalProblem>::iterate(NodalProblem const& problem, Vector const& b, Vector& v,
                                         int max_iterations, bool continues)
{
  TnnmgResult result;
  if (!continues) {
    vectors_.start(*Z_, b, v);
    gather(nodes_, *vectors_.v, blocks_.v);
  }
  int failed_here = 0; // on this rank
  while (result.iterations < max_iterations && !result.converged) {
    ++result.iterations;
    vectors_.beginIteration();
    failed_here += smooth(problem, b, result);
    const bool corrected = correct(problem, b, result);
    auto const norms = vectors_.norms(b, failed_here);
    result.last_change = norms.change;
    result.failed_nodes = norms.failed_nodes;
    // Without a correction, the last change says nothing about the dofs that Gauss-Seidel does not
    // visit.
    result.converged = corrected && result.last_change <= smallChange(norms.v);
  }
  result.converged = result.converged && !result.failed();
  Tpetra::deep_copy(v, *vectors_.v);
  return result;
}

// Returns the number of nodes whose minimisation failed on this rank.
template <class NodalProblem>
int Tnnmg<NodalProblem>::smooth(NodalProblem const& problem, Vector const& b, TnnmgResult& result)
{
  ASPERITY_TIME_WORK("Gauss-Seidel sweeps");
  Kokkos::deep_copy(blocks_.before, blocks_.v);
  int failed_nodes = 0;
  for (int sweep = 0; sweep < settings_.sweeps; ++sweep) {
    failed_nodes += gaussSeidel(*Z_, nodes_, vectors_.exchange, curvature_, problem, b,
                                *vectors_.v_columns, *vectors_.r, blocks_.v, blocks_.residual);
  }
  blocks_.differenceTo(blocks_.before, blocks_.d);
  auto const nonlinear = problem.difference(blocks_.before, blocks_.d);
  result.rises +=
    vectors_.finishSweeps(*Z_, nodes_, blocks_, b, nonlinear.change, nonlinear.magnitude);
  return failed_nodes;
}

template <class NodalProblem>
bool Tnnmg<NodalProblem>::correct(NodalProblem const& problem, Vector const& b, TnnmgResult& result)
{
  return findCorrection(problem, result) && searchAlong(problem, b, result);
}

// False if the linear correction has not converged and is zero or not a number.
template <class NodalProblem>
bool Tnnmg<NodalProblem>::findCorrection(NodalProblem const& problem, TnnmgResult& result)
{
  ASPERITY_TIME_WORK("linear corrections");
  problem.linearise(blocks_.v, blocks_.gradient, blocks_.hessian, blocks_.truncated);
  blocks_.truncate(nodes_, curvature_, settings_.stiff);
  vectors_.newtonResidual(nodes_, blocks_.gradient);
  auto const solved =
    correction_->solve({blocks_.hessian, blocks_.truncated}, *vectors_.newton_residual,
                       settings_.correction_tolerance, *vectors_.c);
  ++result.corrections;
  result.correction_iterations += solved.iterations;
  result.v_cycles += solved.v_cycles;
  if (!solved.converged && !(vectors_.c->norm2() > 0)) { // zero, or not a number
    ++result.lost_corrections;
    return false;
  }
  return true;
}

// False if J does not fall along the correction although the correction is too large to be ignored.
template <class NodalProblem>
bool Tnnmg<NodalProblem>::searchAlong(NodalProblem const& problem, Vector const& b,
                                      TnnmgResult& result)
{
  ASPERITY_TIME_WORK("line searches");
  gather(nodes_, *vectors_.c, blocks_.d);
  // All that a step of one needs, which is the most frequent result, is summed over the ranks at
  // once.
  auto const of_correction = vectors_.derivativeAlongCorrection(*Z_);
  auto const of_step = vectors_.nonlinearChange(problem, blocks_, 1);
  auto const& communicator = *Z_->getComm();
  auto const sums =
    sumOverRanks(std::array<double, 7>{of_correction[0], of_correction[1], of_correction[2],
                                       problem.slope(blocks_.v, blocks_.d, 0),
                                       problem.slope(blocks_.v, blocks_.d, 1), of_step.change,
                                       of_step.magnitude},
                 communicator);
  auto const along = vectors_.keep(sums.data());
  auto const slope = [&](double t) {
    const double of_nodes = t == 0 ? sums[3]
                            : t == 1
                              ? sums[4]
                              : sumOverRanks(problem.slope(blocks_.v, blocks_.d, t), communicator);
    return of_nodes + along.start + t * along.curvature;
  };
  auto const changeAlong = [&](double t) {
    if (t == 1) {
      return vectors_.changeAlong(t, {sums[5], sums[6]});
    }
    auto const mine = vectors_.nonlinearChange(problem, blocks_, t);
    auto const all = sumOverRanks(std::array<double, 2>{mine.change, mine.magnitude}, communicator);
    return vectors_.changeAlong(t, {all[0], all[1]});
  };
  const double start = slope(0);
  double step = findSignChange(slope, start, 1e-2).step;
  auto change = changeAlong(step);
  if (change.change > 0 && step > 0) {
    // The slope at this step was small but positive. Where the slope is not positive, J is certain
    // to be below its start.
    step = findSignChange(slope, start, 0.).step;
    change = changeAlong(step);
  }
  if (!(step > 0) && !(std::sqrt(along.curvature) <= smallChange(vectors_.norms(b, 0).v))) {
    ++result.lost_corrections;
    return false;
  }
  result.rises += change.rises();
  vectors_.move(step);
  gather(nodes_, *vectors_.v, blocks_.v);
  return true;
}
} // namespace asperity::tnnmg
