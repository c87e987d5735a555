#pragma once

#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <memory>

namespace asperity::tnnmg
{
// The linear correction for a small matrix that couples all its dofs (a Schur complement on the
// fault), on one rank: a few conjugate gradients with the diagonal, or, where these do not suffice
// or a factor is cheap, a dense Cholesky factorisation of Z + H, kept until reset(). While the
// factor is kept, it preconditions conjugate gradients for later Hessians; it is made anew when
// they need too many iterations.
// It works in single precision if the tolerance allows that and the residual confirms the result,
// otherwise in double precision.
class DenseCorrection final : public LinearCorrection
{
public:
  // nonlinear(num_nodes, T): the rows of Z(size, size), which is symmetric, at the nonlinear nodes.
  DenseCorrection(ConstBlockView const& Z, NodeDofView const& nonlinear);
  ~DenseCorrection() override;

  CorrectionResult solve(NonlinearBlocks const& blocks, Vector const& r, double relative_tolerance,
                         Vector& c) override;
  void reset() override;

  std::size_t bytes() const; // of its copies of Z and of the factors

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};
} // namespace asperity::tnnmg
