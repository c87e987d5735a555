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
  int rises = 0;            // half steps after which J was larger by more than rounding
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
//       the same for the given nodes one after the other, with r_i = b_i - (Z v)_i +
//       curvature_i v_i of the present v, zero in held components; only for coupledNodes()
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
  Tnnmg(RCP<const CrsMatrix> Z, NonlinearNodes nodes, std::shared_ptr<LinearCorrection> correction,
        TnnmgSettings const& settings)
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
  void smooth(NodalProblem const& problem, Vector const& b, TnnmgResult& result);
  bool correct(NodalProblem const& problem, Vector const& b, TnnmgResult& result);
  bool findCorrection(NodalProblem const& problem, TnnmgResult& result);
  bool searchAlong(NodalProblem const& problem, Vector const& b, TnnmgResult& result);
  double smallChange(Vector const& b) const;
  double moveAlong(NodalProblem const& problem, double step);

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
  while (result.iterations < max_iterations && !result.converged) {
    ++result.iterations;
    vectors_.beginIteration();
    smooth(problem, b, result);
    const bool corrected = correct(problem, b, result);
    result.last_change = vectors_.energyOfChange();
    // Without a correction, the last change says nothing about the dofs that Gauss-Seidel does not
    // visit.
    result.converged = corrected && result.last_change <= smallChange(b);
  }
  result.failed_nodes = sumOverRanks(result.failed_nodes, *Z_->getComm());
  result.converged = result.converged && !result.failed();
  Tpetra::deep_copy(v, *vectors_.v);
  return result;
}

// The largest change that counts as converged, in the energy norm.
template <class NodalProblem>
double Tnnmg<NodalProblem>::smallChange(Vector const& b) const
{
  return std::max(settings_.absolute_tolerance,
                  settings_.relative_tolerance * vectors_.energyNorm(b));
}

template <class NodalProblem>
void Tnnmg<NodalProblem>::smooth(NodalProblem const& problem, Vector const& b, TnnmgResult& result)
{
  ASPERITY_TIME_WORK("Gauss-Seidel sweeps");
  Kokkos::deep_copy(blocks_.before, blocks_.v);
  for (int sweep = 0; sweep < settings_.sweeps; ++sweep) {
    result.failed_nodes += gaussSeidel(*Z_, nodes_, curvature_, problem, b, *vectors_.v_columns,
                                       blocks_.v, blocks_.residual);
  }
  blocks_.differenceTo(blocks_.before, blocks_.d);
  auto const nonlinear = problem.difference(blocks_.before, blocks_.d);
  result.rises +=
    vectors_.finishSweeps(*Z_, nodes_, blocks_, b, nonlinear.change, nonlinear.magnitude);
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
  auto const along = vectors_.derivativeAlongCorrection(*Z_);
  auto const slope = [&](double t) {
    return sumOverRanks(problem.slope(blocks_.v, blocks_.d, t), *Z_->getComm()) + along.start +
           t * along.curvature;
  };
  const double start = slope(0);
  double step = findSignChange(slope, start, 1e-2).step;
  auto change = vectors_.changeAlong(*Z_, problem, blocks_, step);
  if (change.change > 0 && step > 0) {
    // The slope at this step was small but positive. Where the slope is not positive, J is certain
    // to be below its start.
    step = findSignChange(slope, start, 0.).step;
    change = vectors_.changeAlong(*Z_, problem, blocks_, step);
  }
  if (!(step > 0) && !(std::sqrt(along.curvature) <= smallChange(b))) {
    ++result.lost_corrections;
    return false;
  }
  result.rises += change.rises();
  vectors_.move(step);
  shareGhosts(*Z_, *vectors_.v_columns);
  gather(nodes_, *vectors_.v, blocks_.v);
  return true;
}
} // namespace asperity::tnnmg
