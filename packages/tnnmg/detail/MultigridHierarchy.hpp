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
  // The default parameters, in MueLu's own spelling; the user may override them. `components` is
  // the number of displacement components of a node.
  static Teuchos::ParameterList defaults(int components);

  // A must be symmetric positive definite, and near_null_space almost zero at rows without
  // off-diagonal entries. The constructor and rebuild() throw SolveError if MueLu fails;
  // std::bad_alloc is passed on.
  MultigridHierarchy(RCP<const CrsMatrix> A, RCP<const MultiVector> near_null_space,
                     Teuchos::ParameterList const& muelu);
  ~MultigridHierarchy();

  // Keeps the prolongators and repeats the Galerkin products with a matrix of the same graph,
  // stored zeros included.
  void rebuild(RCP<const CrsMatrix> A);

  // z is the result of one V-cycle for A z = r that starts from zero.
  void apply(MultiVector const& r, MultiVector& z) const;

private:
  struct Implementation;

  void setCoarseSolver();

  std::unique_ptr<Implementation> implementation_;
};
} // namespace asperity::tnnmg::detail
