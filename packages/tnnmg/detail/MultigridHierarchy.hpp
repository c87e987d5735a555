#pragma once

#include "base/Types.hpp"
#include "portability/Spaces.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>

namespace asperity::tnnmg::detail
{
// How kernels run decides on the smoother. Ifpack2's symmetric Gauss-Seidel is a serial loop.
enum class Parallelism
{
  serial,
  threads,
  device
};

// That of this build.
constexpr Parallelism parallelism = kernels_run_serially  ? Parallelism::serial
                                    : kernels_run_on_host ? Parallelism::threads
                                                          : Parallelism::device;

// A MueLu hierarchy with CoarseCholesky on its coarsest level.
class MultigridHierarchy
{
public:
  // The default parameters, in MueLu's own spelling; the user may override them. `components` is
  // the number of displacement components of a node. Tests ask for those of other builds.
  static Teuchos::ParameterList defaults(int components, Parallelism kernels = parallelism);

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
