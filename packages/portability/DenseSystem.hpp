#pragma once

#include "portability/Views.hpp"

namespace asperity
{
// Bounds of the last unknown of each block, perhaps infinite: lower(n) <= upper(n).
struct Bounds
{
  bool exist = false; // the same on all ranks; otherwise no unknown has bounds, nor views entries
  ConstNodeView lower = {}, upper = {};
};

// The number between these bounds that is nearest to x.
KOKKOS_INLINE_FUNCTION double within(double lower, double x, double upper)
{
  return x < lower ? lower : x > upper ? upper : x;
}

// A symmetric linear system Z v = b of n blocks with T unknowns each, in which every block is
// coupled with every other one, and its residual at the present v. The rows and columns of Z are
// the T unknowns of block 0, then those of block 1, and so on.
struct DenseSystem
{
  ConstBlockView Z;        // (n T, n T)
  BlockView r;             // (n, T): b - Z v
  ConstFlagView held;      // (n T): 1 where an unknown keeps its value, and r does not count
  ConstNodeView curvature; // (n), > 0: stands for the diagonal block of Z, as a multiple of 1
  Bounds bounds = {};
};
} // namespace asperity
