#pragma once

#include "base/Types.hpp"

#include <memory>

namespace asperity::tnnmg::detail
{
// A direct solve with a small symmetric positive definite matrix that is spread over all ranks:
// rank 0 gathers and factorises it (Eigen's sparse Cholesky). Amesos2's KLU2, MueLu's default,
// gives wrong answers on two and more ranks.
class CoarseCholesky
{
public:
  // Throws SolveError on every rank if A is not positive definite. Rows without entries count as
  // identity.
  explicit CoarseCholesky(CrsMatrix const& A);
  ~CoarseCholesky();

  // x = A^-1 b for one vector b; both live on A's row map. All ranks call it together.
  void solve(MultiVector const& b, MultiVector& x) const;

private:
  struct Factor;

  void factorise(CrsMatrix const& gathered);

  RCP<const Import> gather_; // A's row map -> everything on rank 0
  RCP<MultiVector> gathered_;
  std::unique_ptr<Factor> factor_; // used on rank 0 alone
};
} // namespace asperity::tnnmg::detail
