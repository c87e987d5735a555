#include "tnnmg/hierarchy/MultigridProlongators.hpp"

#include "base/Errors.hpp"
#include "tnnmg/hierarchy/FewerRanks.hpp"
#include "tnnmg/hierarchy/TrilinosMessages.hpp"

#include <MueLu_Hierarchy.hpp>
#include <MueLu_Level.hpp>
#include <MueLu_MasterList.hpp>
#include <MueLu_ParameterListInterpreter.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Xpetra_CrsMatrixWrap.hpp>
#include <Xpetra_TpetraCrsMatrix.hpp>
#include <Xpetra_TpetraMultiVector.hpp>

#include <exception>
#include <new>

namespace asperity::tnnmg::detail
{
namespace
{
using Node = CrsMatrix::node_type;
// MueLu's interface uses Xpetra's wrappers. These classes are in every release of Trilinos; the
// functions that wrap and unwrap have different names in different releases.
using XpetraMatrix = Xpetra::Matrix<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraCrsMatrix = Xpetra::CrsMatrix<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraWrap = Xpetra::CrsMatrixWrap<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraTpetraMatrix = Xpetra::TpetraCrsMatrix<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraVectors = Xpetra::MultiVector<double, LocalOrdinal, GlobalOrdinal, Node>;
using XpetraTpetraVectors = Xpetra::TpetraMultiVector<double, LocalOrdinal, GlobalOrdinal, Node>;
using Interpreter = MueLu::ParameterListInterpreter<double, LocalOrdinal, GlobalOrdinal, Node>;

// A level to be aggregated.
struct Level
{
  RCP<const CrsMatrix> A;
  RCP<const MultiVector> near_null_space;
};

// MueLu's hierarchy below a level, which is its level 0.
class Hierarchy
{
public:
  Hierarchy(Level const& level, Teuchos::ParameterList const& muelu)
      : list_(muelu) // MueLu writes into it
      , interpreter_(list_, level.A->getComm())
      , hierarchy_(interpreter_.CreateHierarchy())
  {
    hierarchy_->setlib(Xpetra::UseTpetra);
    // MueLu's interface takes a matrix that is not const. It changes the matrix only if it scales
    // or rebalances it, which we never ask for.
    const RCP<XpetraCrsMatrix> A =
      rcp(new XpetraTpetraMatrix(Teuchos::rcp_const_cast<CrsMatrix>(level.A)));
    hierarchy_->GetLevel(0)->Set<RCP<XpetraMatrix>>("A", rcp(new XpetraWrap(A)));
    const auto vectors = rcp(new MultiVector(*level.near_null_space, Teuchos::Copy));
    hierarchy_->GetLevel(0)->Set<RCP<XpetraVectors>>("Nullspace",
                                                     rcp(new XpetraTpetraVectors(vectors)));
    interpreter_.SetupHierarchy(*hierarchy_);
  }

  int numLevels() const { return hierarchy_->GetNumLevels(); }
  RCP<const CrsMatrix> prolongator(int level) const { return get(level, "P"); }
  RCP<const CrsMatrix> matrix(int level) const { return get(level, "A"); }
  // Of a level between the first and the last: MueLu has it because it is asked to keep what
  // "reuse: type" = "RP" needs.
  RCP<const MultiVector> nearNullSpace(int level) const
  {
    auto const factory = interpreter_.GetFactoryManager(level)->GetFactory("Nullspace");
    return Teuchos::rcp_dynamic_cast<XpetraTpetraVectors>(
             hierarchy_->GetLevel(level)->Get<RCP<XpetraVectors>>("Nullspace", factory.get()), true)
      ->getTpetra_MultiVector();
  }

private:
  RCP<const CrsMatrix> get(int level, char const* name) const
  {
    const auto wrap = Teuchos::rcp_dynamic_cast<XpetraWrap>(
      hierarchy_->GetLevel(level)->Get<RCP<XpetraMatrix>>(name), true);
    return Teuchos::rcp_dynamic_cast<XpetraTpetraMatrix>(wrap->getCrsMatrix(), true)
      ->getTpetra_CrsMatrix();
  }

  Teuchos::ParameterList list_;
  Interpreter interpreter_;
  RCP<MueLu::Hierarchy<double, LocalOrdinal, GlobalOrdinal, Node>> hierarchy_;
};

// Appends the levels down to the first one that has to move, and returns that level after the move;
// a level without matrix if nothing is left to be aggregated.
Level aggregate(Level const& level, Teuchos::ParameterList const& muelu, int rows_per_rank,
                std::vector<ProjectedLevel>& levels)
{
  const Hierarchy hierarchy(level, muelu);
  for (int l = 1; l < hierarchy.numLevels(); ++l) {
    const auto P = hierarchy.prolongator(l);
    const auto owners = onFewerRanks(*P->getDomainMap(), rows_per_rank);
    const auto A = hierarchy.matrix(l);
    if (owners.is_null()) {
      levels.push_back({P, A});
      continue;
    }
    levels.push_back({withColumnsOn(owners, *P), movedTo(owners, A)});
    if (l + 1 < hierarchy.numLevels()) {
      return {levels.back().A, movedTo(owners, *hierarchy.nearNullSpace(l))};
    }
  }
  return {};
}
} // namespace

// A failure is due to the matrix or the list, except a lack of memory, which is passed on.
std::vector<ProjectedLevel> coarseLevels(RCP<const CrsMatrix> const& A,
                                         RCP<const MultiVector> const& near_null_space,
                                         Teuchos::ParameterList const& muelu, int rows_per_rank)
{
  Teuchos::ParameterList list(muelu);
  std::vector<ProjectedLevel> result;
  try {
    const int most_levels =
      list.get("max levels", MueLu::MasterList::getDefault<int>("max levels"));
    Level level = {A, near_null_space};
    while (!level.A.is_null()) {
      list.set("max levels", most_levels - static_cast<int>(result.size()));
      level = aggregate(level, list, rows_per_rank, result);
      list.set("number of equations", static_cast<int>(near_null_space->getNumVectors()));
    }
  } catch (std::bad_alloc const&) {
    throw;
  } catch (std::exception const& error) {
    throw SolveError("MueLu cannot set up a multigrid hierarchy: " + complaint(error.what()) +
                     " Other parameters in the list MueLu, or 'Linear Correction' = Direct on one "
                     "rank, may help.");
  }
  return result;
}
} // namespace asperity::tnnmg::detail
