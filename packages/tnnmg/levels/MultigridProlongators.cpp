#include "tnnmg/levels/MultigridProlongators.hpp"

#include "base/Errors.hpp"
#include "tnnmg/detail/MultigridTrial.hpp"

#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <exception>
#include <new>

namespace asperity::tnnmg::detail
{
namespace
{
using Node = CrsMatrix::node_type;
using XpetraMatrix = Xpetra::Matrix<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraTools = MueLu::Utilities<double, LocalOrdinal, GlobalOrdinal, Node>;
} // namespace

// The set-up fails for its matrix or its list; memory that is missing is no matter of either.
std::vector<RCP<const CrsMatrix>> prolongators(RCP<const CrsMatrix> const& A,
                                               MultiVector const& near_null_space,
                                               Teuchos::ParameterList const& muelu)
{
  Teuchos::ParameterList list(muelu); // MueLu writes into it
  list.sublist("user data").set("Nullspace", rcp(new MultiVector(near_null_space, Teuchos::Copy)));
  // MueLu's interface takes a matrix that is not const. It changes the matrix only if it scales or
  // rebalances it, which we never ask for.
  RCP<Tpetra::Operator<double, LocalOrdinal, GlobalOrdinal, Node>> fine =
    Teuchos::rcp_const_cast<CrsMatrix>(A);
  try {
    const auto hierarchy = MueLu::CreateTpetraPreconditioner(fine, list)->GetHierarchy();
    std::vector<RCP<const CrsMatrix>> result;
    for (int level = 1; level < hierarchy->GetNumLevels(); ++level) {
      result.push_back(
        XpetraTools::Op2TpetraCrs(hierarchy->GetLevel(level)->Get<RCP<XpetraMatrix>>("P")));
    }
    return result;
  } catch (std::bad_alloc const&) {
    throw;
  } catch (std::exception const& error) {
    throw SolveError("MueLu cannot set up a multigrid hierarchy: " + complaint(error.what()) +
                     " Other parameters in the list MueLu, or 'Linear Correction' = Direct on one "
                     "rank, may help.");
  }
}
} // namespace asperity::tnnmg::detail
