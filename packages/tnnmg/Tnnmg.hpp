#pragma once

#include "tnnmg/BoundedNodes.hpp"
#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/RateMatrix.hpp"
#include "tnnmg/TnnmgSettings.hpp"
#include "tnnmg/TnnmgVectors.hpp"

#include <cmath>
#include <memory>
#include <optional>

namespace asperity::tnnmg
{
struct TnnmgResult
{
  bool converged = false;
  int iterations = 0;
  int corrections = 0;
  int correction_iterations = 0; // of conjugate gradients
  int v_cycles = 0;
  int energy_increases = 0;   // sweeps and corrections in which J grew by more than rounding
  int failed_corrections = 0; // corrections that were zero, or along which J did not fall
  double last_change = 0;     // of v, in the energy norm
  double error = 0;           // estimate of the distance to the minimiser, in the same norm
  int failed_nodes = 0;       // on any rank

  // True if more iterations would not help: a node failed, or a value is not finite.
  bool failed() const { return failed_nodes > 0 || !std::isfinite(last_change); }
};

// Truncated nonsmooth Newton multigrid (Gräser and Kornhuber 2009; Pipping 2014, ch. 4): minimises
//   J(v) = 1/2 <Z v, v> - <b, v> + sum over nonlinear nodes of psi_i(v_i),   psi_i convex,
// by iterations that each lower J: a nonlinear Gauss-Seidel sweep over the nonlinear nodes,
// truncation of the nodes where psi has no useful second derivative, a linear correction for all
// dofs, and a line search. Bounds of a component (NodalProblem::bounds) are a part of psi: sweeps
// end within them, the correction is zero in components at a bound, and the line search ends within
// them. All ranks call each function together.
class Tnnmg
{
public:
  Tnnmg(std::shared_ptr<const RateMatrix> Z, std::shared_ptr<LinearCorrection> correction,
        TnnmgSettings const& settings);

  // Takes a new right side b and a first guess for v, on Z's rows.
  void begin(Vector const& b, Vector const& guess);
  // Both functions start from the present v; improve() makes a single iteration, for problems that
  // change before they need to be solved.
  TnnmgResult solve(NodalProblem const& problem);
  TnnmgResult improve(NodalProblem const& problem);

  Vector const& v() const { return *vectors_.v; }
  BlockView const& vAtNodes() const { return blocks_.v; } // (num_nodes, T)

private:
  void takeBounds(NodalProblem const& problem);
  void computeResidual();
  TnnmgResult iterate(NodalProblem const& problem, int max_iterations);
  int smooth(NodalProblem const& problem, TnnmgResult& result);
  bool findCorrection(NodalProblem const& problem, TnnmgResult& result);
  double confineCorrection(NodalProblem const& problem);
  bool searchAlong(NodalProblem const& problem, TnnmgResult& result);
  EnergyChange nonlinearChange(NodalProblem const& problem, double step) const;
  // The largest error that counts as none, in the energy norm; norm: that of v.
  double smallError(double norm) const;
  // An estimate of the error of v after an iteration that changed it by this. left: the share of
  // the error that its correction leaves.
  double errorAfter(double change, double left);

  std::shared_ptr<const RateMatrix> Z_;
  std::shared_ptr<LinearCorrection> correction_;
  TnnmgSettings settings_;
  detail::TnnmgVectors vectors_;
  detail::TnnmgBlocks blocks_;
  std::optional<detail::BoundedNodes> bounded_; // if the problem has bounds
  bool has_residual_ = false;                   // of the present v
  double last_change_ = 0;                      // of v
  double last_ratio_ = 0;                       // the last change relative to the one before it
  double remaining_share_ = 1;                  // of the error, by the last correction
};
} // namespace asperity::tnnmg
