#pragma once

#include "base/Views.hpp"

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
  Kokkos::View<const int*, MemorySpace> truncated;
};

// What one correction took. Not converged is an answer, not an error: the line search makes it
// harmless. Not converged and zero is no answer, and TNNMG does not stop with it.
struct CorrectionResult
{
  bool converged = false;
  int iterations = 0; // of conjugate gradients, or cycles where these run alone
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

  // Forgets what earlier solves left behind (a kept hierarchy), so that the next depends on its
  // arguments alone.
  virtual void reset() {}
};
} // namespace asperity::tnnmg
