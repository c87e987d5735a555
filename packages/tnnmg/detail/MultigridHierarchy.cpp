#include "tnnmg/detail/MultigridHierarchy.hpp"

#include "base/Errors.hpp"
#include "tnnmg/detail/CoarseCholesky.hpp"
#include "tnnmg/detail/MultigridTrial.hpp"

#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <MueLu_SmootherBase.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <exception>
#include <new>
#include <string>

namespace asperity::tnnmg::detail
{
namespace
{
using Node = CrsMatrix::node_type;
using MueLuOperator = MueLu::TpetraOperator<double, LocalOrdinal, GlobalOrdinal, Node>;
using MueLuSmoother = MueLu::SmootherBase<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraMatrix = Xpetra::Matrix<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraVector = Xpetra::MultiVector<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraTools = MueLu::Utilities<double, LocalOrdinal, GlobalOrdinal, Node>;

// MueLu's cycle calls the "pre-smoother" on the coarsest level, so that the direct solver takes its
// place.
class CoarseSmoother : public MueLuSmoother
{
public:
  explicit CoarseSmoother(asperity::CrsMatrix const& A) : solver_(A) {}

  void Apply(XpetraVector& x, XpetraVector const& b, bool) const override
  {
    solver_.solve(XpetraTools::MV2TpetraMV(b), XpetraTools::MV2NonConstTpetraMV(x));
  }

  std::size_t getNodeSmootherComplexity() const override
  {
    return Teuchos::OrdinalTraits<std::size_t>::invalid();
  }

private:
  CoarseCholesky solver_;
};

// MueLu's interface takes a matrix that is not const. It changes the matrix only if it scales or
// rebalances it, which we never ask for.
RCP<CrsMatrix> writable(RCP<const CrsMatrix> const& A)
{
  return Teuchos::rcp_const_cast<CrsMatrix>(A);
}

// Measured on 1 to 12 ranks: with Gauss-Seidel that is local to a rank, conjugate gradients need 5
// to 17 iterations where they need 11 to 20 with Chebyshev, and no more on 12 ranks than on one.
// The multithreaded Gauss-Seidel goes by colours and needs one V-cycle in a hundred more. On
// devices Gauss-Seidel is too slow.
void setSmoother(Teuchos::ParameterList& list, Parallelism kernels)
{
  auto& parameters = list.sublist("smoother: params");
  if (kernels == Parallelism::device) {
    list.set("smoother: type", "CHEBYSHEV");
    parameters.set("chebyshev: degree", 2);
    return;
  }
  list.set("smoother: type", "RELAXATION");
  parameters.set("relaxation: type", kernels == Parallelism::serial ? "Symmetric Gauss-Seidel"
                                                                    : "MT Symmetric Gauss-Seidel");
  parameters.set("relaxation: sweeps", 1);
}
} // namespace

struct MultigridHierarchy::Implementation
{
  RCP<MueLuOperator> muelu;
};

Teuchos::ParameterList MultigridHierarchy::defaults(int components, Parallelism kernels)
{
  Teuchos::ParameterList list("MueLu");
  list.set("verbosity", "none");
  list.set("number of equations", components);
  list.set("multigrid algorithm", "sa");
  list.set("coarse: max size", 1000);
  list.set("coarse: type", "none"); // CoarseCholesky takes its place
  list.set("reuse: type", "RP");
  list.set("transpose: use implicit", true); // keeps no restrictions in memory
  list.set("rap: fix zero diagonals",
           true); // where an aggregate loses a near null vector to constraints
  // "aggregation: drop tol" stays at zero: MueLu's factories for threads and devices refuse it
  // where a node has several equations.
  setSmoother(list, kernels);
  return list;
}

namespace
{
// The set-up fails for its matrix or its list; memory that is missing is no matter of either.
template <class Work>
void callMueLu(Work const& work)
{
  try {
    work();
  } catch (std::bad_alloc const&) {
    throw;
  } catch (std::exception const& error) {
    throw SolveError("MueLu cannot set up a multigrid hierarchy: " + complaint(error.what()) +
                     " Other parameters in the list MueLu, or 'Linear Correction' = Direct on one "
                     "rank, may help.");
  }
}
} // namespace

MultigridHierarchy::MultigridHierarchy(RCP<const CrsMatrix> A,
                                       RCP<const MultiVector> near_null_space,
                                       Teuchos::ParameterList const& muelu)
    : implementation_(std::make_unique<Implementation>())
{
  Teuchos::ParameterList list(muelu); // MueLu writes into it
  list.sublist("user data").set("Nullspace", rcp(new MultiVector(*near_null_space, Teuchos::Copy)));
  RCP<Tpetra::Operator<double, LocalOrdinal, GlobalOrdinal, Node>> fine = writable(A);
  callMueLu([&] { implementation_->muelu = MueLu::CreateTpetraPreconditioner(fine, list); });
  setCoarseSolver();
}

MultigridHierarchy::~MultigridHierarchy() = default;

void MultigridHierarchy::rebuild(RCP<const CrsMatrix> A)
{
  callMueLu([&] { MueLu::ReuseTpetraPreconditioner(writable(A), *implementation_->muelu); });
  setCoarseSolver();
}

void MultigridHierarchy::apply(MultiVector const& r, MultiVector& z) const
{
  implementation_->muelu->apply(r, z);
}

void MultigridHierarchy::setCoarseSolver()
{
  const auto hierarchy = implementation_->muelu->GetHierarchy();
  const auto coarsest = hierarchy->GetLevel(hierarchy->GetNumLevels() - 1);
  const auto A = coarsest->Get<RCP<XpetraMatrix>>("A");
  const RCP<MueLuSmoother> solver = rcp(new CoarseSmoother(*XpetraTools::Op2TpetraCrs(A)));
  coarsest->Set("PreSmoother", solver);
}
} // namespace asperity::tnnmg::detail
