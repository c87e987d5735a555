#pragma once

#include "tnnmg/NonlinearNodes.hpp"
#include "tnnmg/direct/EliminationOrder.hpp"

#include <Tpetra_Vector.hpp>

#include <memory>
#include <vector>

namespace asperity::tnnmg
{
namespace detail
{
struct EliminationFactor;
}

// What SchurComplement::condense leaves of a right side b, and what it keeps for the way back.
class CondensedRightSide
{
public:
  // b_F - Z_FI Z_II^-1 b_I
  Vector const& kept() const { return kept_; }
  // v (all rows) has the values v_kept on the kept rows and minimises J over all other dofs.
  void expand(Vector const& v_kept, Vector& v) const;

private:
  friend class SchurComplement;
  CondensedRightSide(std::shared_ptr<const detail::EliminationFactor> factor, Vector const& b,
                     RCP<const Map> const& map);

  std::shared_ptr<const detail::EliminationFactor> factor_;
  std::vector<double> half_solved_; // L_I^-1 b_I in the order of elimination, b_kept behind it
  Vector kept_;
};

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

  // S, symmetric to the last bit, and a map of its rows, both in the order of `rows`.
  ConstBlockView const& matrix() const { return matrix_; }
  RCP<const Map> const& map() const { return map_; }

  CondensedRightSide condense(Vector const& b) const { return {factor_, b, map_}; }

  std::size_t factorEntries() const; // of L
  std::size_t bytes() const;

private:
  std::shared_ptr<const detail::EliminationFactor> factor_;
  ConstBlockView matrix_;
  RCP<const Map> map_;
};
} // namespace asperity::tnnmg
