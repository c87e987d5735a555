#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Eigen/Core>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <cstddef>

namespace asperity::dynamics
{
// Linear functionals N w of the minimiser w over all dofs but those of the fault, as functions of
// the velocity w_F of the fault: N w = (N_F - N_I Z_II^-1 Z_IF) w_F + N_I Z_II^-1 b_I. The matrix
// is full, and made once; the constant costs one triangular solve for each right side.
class CondensedFunctionals
{
public:
  // N: (any number of rows, owned dofs).
  CondensedFunctionals(tnnmg::SchurComplement const& schur, RCP<const CrsMatrix> const& N);

  // Takes a new right side.
  void begin(tnnmg::CondensedRightSide const& b);
  // r(rows of N) = N w where the fault has the velocity w_kept.
  void apply(Vector const& w_kept, NodeView const& r) const;

  std::size_t bytes() const { return sizeof(double) * static_cast<std::size_t>(matrix_.size()); }

private:
  RCP<const CrsMatrix> N_;
  Vector at_rest_, constant_; // w where the fault is at rest; N of it
  Vector zero_;
  Eigen::MatrixXd matrix_;
};
} // namespace asperity::dynamics
