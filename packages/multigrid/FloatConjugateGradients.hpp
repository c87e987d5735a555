#pragma once

#include "multigrid/Cycle.hpp"

namespace asperity::multigrid
{
struct IterationResult
{
  bool converged = false;
  int iterations = 0;
};

// Conjugate gradients in single precision with a V-cycle as preconditioner, for relative tolerances
// of a thousandth and above. The cycle gives the product with Z + H along with its result, the
// image of the direction follows from it by recurrence (Chronopoulos and Gear 1989), and all inner
// products of an iteration are summed over the ranks at once.
class FloatConjugateGradients
{
public:
  // The smallest relative tolerance: rounding separates the true residual from the one that the
  // iteration updates by less than this.
  static constexpr double smallest_tolerance = 1e-3;

  // The cycle must outlive this.
  FloatConjugateGradients(Cycle& cycle, SumOverRanks sum);

  // (Z + H) c = r, from zero, until the residual is at most relative_tolerance |r|; r is zero at
  // removed and held dofs, and norm is |r| over all ranks. It does not converge if rounding has
  // made the cycle indefinite, or if max_iterations are not enough. Collective.
  IterationResult solve(ConstNodeView const& r, double norm, double relative_tolerance,
                        int max_iterations, NodeView const& c);

private:
  Cycle& cycle_;
  SumOverRanks sum_;
  NodeVector r_, c_, p_, s_; // s = (Z + H) p; all in the order of the cycle's rows
};
} // namespace asperity::multigrid
