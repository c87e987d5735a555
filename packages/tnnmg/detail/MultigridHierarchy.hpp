#pragma once

#include "base/Types.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>

namespace asperity::tnnmg::detail
{
// A MueLu hierarchy with CoarseCholesky on its coarsest level.
class MultigridHierarchy
{
public:
  // MueLu's parameters, in its own spelling, which the user may override. `components` is the
  // number of displacement components of a node.
  static Teuchos::ParameterList defaults(int components);

  // A is symmetric positive definite. near_null_space is almost zero at rows without off-diagonal
  // entries. SolveError where MueLu fails, here and in rebuild(); std::bad_alloc passes.
  MultigridHierarchy(RCP<const CrsMatrix> A, RCP<const MultiVector> near_null_space,
                     Teuchos::ParameterList const& muelu);
  ~MultigridHierarchy();

  // Keeps the prolongators and repeats the Galerkin products with a matrix of the same graph,
  // stored zeros included.
  void rebuild(RCP<const CrsMatrix> A);

  // z = one V-cycle for A z = r, from zero.
  void apply(MultiVector const& r, MultiVector& z) const;

private:
  struct Implementation;

  void setCoarseSolver();

  std::unique_ptr<Implementation> implementation_;
};
} // namespace asperity::tnnmg::detail
