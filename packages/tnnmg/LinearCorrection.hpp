#pragma once

#include "base/Views.hpp"

#include <Tpetra_Vector.hpp>

namespace asperity::tnnmg
{
// The second derivatives of the nonlinearity at the rank's nonlinear nodes, in the order of
// NonlinearNodes.
struct NonlinearBlocks
{
  // (num_nodes, T, T), symmetric positive semidefinite, in the units of Z. Entries of truncated
  // nodes are not read.
  Kokkos::View<const double***, Kokkos::LayoutRight, MemorySpace> hessian;
  // (num_nodes): 1 if the node is left out of the correction, 0 otherwise.
  ConstFlagView truncated;
};

// The effort of one correction. A correction that has not converged is still usable, because the
// line search limits the step along it. If it is zero as well, TNNMG cannot use it and does not
// count as converged in that iteration.
struct CorrectionResult
{
  bool converged = false;
  int iterations = 0; // of conjugate gradients, or V-cycles if they are used alone
  int v_cycles = 0;
};

// The linear step of TNNMG: c ~ (Z + H)^-1 r on the dofs that are neither truncated nor
// constrained, where H holds the blocks of NonlinearBlocks. All ranks call it together.
class LinearCorrection
{
public:
  virtual ~LinearCorrection() = default;

  // r and c live on Z's row map; c is overwritten and is zero at truncated and constrained dofs,
  // where r is not read. relative_tolerance bounds |r - (Z + H) c| / |r| (Euclidean norm over the
  // remaining dofs).
  virtual CorrectionResult solve(NonlinearBlocks const& blocks, Vector const& r,
                                 double relative_tolerance, Vector& c) = 0;

  // Discards what earlier solves have left, such as a kept hierarchy, so that the next solve
  // depends on its arguments alone.
  virtual void reset() {}
};
} // namespace asperity::tnnmg
