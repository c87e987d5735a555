#pragma once

#include "base/Types.hpp"
#include "tnnmg/EliminationOrder.hpp"

#include <memory>
#include <vector>

namespace asperity::tnnmg
{
// Sparse Cholesky factorisation of Z on one rank, with chosen rows (those of the fault) last:
//
//   P Z P^T = [L_I    0 ] [L_I^T  L_FI^T]      S = Z_FF - Z_FI Z_II^-1 Z_IF = L_F L_F^T
//             [L_FI  L_F] [0      L_F^T ]
//
// Since only the fault is nonlinear, minimising J over all other dofs leaves a problem of the same
// form in which S replaces Z. One triangular solve is needed before it and one after it.
class SchurComplement
{
public:
  // Z must be symmetric and live on one rank; rows: the local rows to keep. Throws SolveError if Z
  // is not positive definite.
  SchurComplement(CrsMatrix const& Z, std::vector<int> const& rows);
  // With an order that other matrices of the same entries may have found, or find here.
  SchurComplement(CrsMatrix const& Z, std::vector<int> const& rows, EliminationOrder& order);
  ~SchurComplement();

  // S as a full matrix in CRS form, in the order of `rows`.
  RCP<const CrsMatrix> const& matrix() const { return matrix_; }

  // Computes b_kept = b_F - Z_FI Z_II^-1 b_I (the kept rows) from b (all rows). Stores L_I^-1 b_I
  // for expand.
  void condense(Vector const& b, Vector& b_kept);

  // v (all rows) has the values v_kept on the kept rows and minimises J over all other dofs, for
  // the b of the last condense.
  void expand(Vector const& v_kept, Vector& v) const;

  std::size_t factorEntries() const; // of L
  std::size_t bytes() const;

private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
  RCP<const CrsMatrix> matrix_;
};
} // namespace asperity::tnnmg
