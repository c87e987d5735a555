#pragma once

#include "tnnmg/correction/MultigridNodes.hpp"

#include <memory>

namespace asperity::tnnmg::detail
{
// The Hessians that the coarse levels of a preconditioner have: those of an earlier solve, or none.
// There a Hessian H counts as the parallel sum of itself and B, the block of Z,
// (H^-1 + B^-1)^-1 = B - B (H + B)^-1 B, which is no larger than either, and a removed node as B.
// Without this limit a stiff node would hold whole coarse functions, which then correct nothing.
class CoarseHessians
{
public:
  explicit CoarseHessians(std::shared_ptr<const MultigridNodes> nodes);

  HessianView const& values() const { return values_; } // (num_nodes, T, T)

  // The share of the nonlinear nodes of all ranks whose current Hessian differs in its trace by
  // more than a factor of three. A hundredth of the trace of Z's block is added to both, so that
  // changes of small Hessians do not count. Collective.
  double outdatedShare(Communicator const& communicator) const;

  void takeCurrent();
  // Zero from now on. forgotten() is true once after it, if Hessians had been taken before and none
  // were since: the coarse levels have to lose theirs.
  void forget();
  bool forgotten();

private:
  std::shared_ptr<const MultigridNodes> nodes_;
  HessianView values_;
  bool taken_ = false; // by the coarse levels
  bool forgets_ = false;
};
} // namespace asperity::tnnmg::detail
