#include "tnnmg/hierarchy/MueLuHierarchy.hpp"

#include "base/Errors.hpp"
#include "tnnmg/hierarchy/TrilinosMessages.hpp"

#include <MueLu_Hierarchy.hpp>
#include <MueLu_Level.hpp>
#include <MueLu_NoFactory.hpp>
#include <MueLu_ParameterListInterpreter.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Xpetra_CrsMatrixWrap.hpp>
#include <Xpetra_TpetraCrsMatrix.hpp>
#include <Xpetra_TpetraMultiVector.hpp>

#include <exception>
#include <new>
#include <string>

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

// MueLu's interface takes a matrix that is not const. It changes the matrix only if it scales or
// rebalances it, which we never ask for.
RCP<XpetraMatrix> wrap(RCP<const CrsMatrix> const& A)
{
  const RCP<XpetraCrsMatrix> inner =
    rcp(new XpetraTpetraMatrix(Teuchos::rcp_const_cast<CrsMatrix>(A)));
  return rcp(new XpetraWrap(inner));
}

RCP<XpetraVectors> wrap(RCP<MultiVector> const& x) { return rcp(new XpetraTpetraVectors(x)); }

std::string levelName(std::size_t level) { return "level " + std::to_string(level); }

// The list with what MueLu's interpreter asks before it makes factories of its own.
Teuchos::ParameterList withProlongators(Teuchos::ParameterList list,
                                        std::vector<RCP<XpetraMatrix>> const& P)
{
  list.set("max levels", static_cast<int>(P.size()) + 1);
  list.set("coarse: max size", 1);
  for (std::size_t k = 0; k < P.size(); ++k) {
    list.sublist(levelName(k + 1)).set("P", P[k]);
  }
  return list;
}

std::vector<RCP<XpetraMatrix>> wrapAll(std::vector<RCP<const CrsMatrix>> const& P)
{
  std::vector<RCP<XpetraMatrix>> wrapped;
  for (auto const& one : P) {
    wrapped.push_back(wrap(one));
  }
  return wrapped;
}
} // namespace

struct MueLuHierarchy::Implementation
{
  Implementation(RCP<const CrsMatrix> const& A, RCP<const MultiVector> const& near_null_space,
                 std::vector<RCP<XpetraMatrix>> const& P, Teuchos::ParameterList const& muelu)
      : list(muelu) // MueLu writes into it
      , interpreter(list, A->getComm())
      , hierarchy(interpreter.CreateHierarchy())
  {
    hierarchy->setlib(Xpetra::UseTpetra);
    hierarchy->GetLevel(0)->Set<RCP<XpetraMatrix>>("A", wrap(A));
    if (!near_null_space.is_null()) {
      const auto vectors = rcp(new MultiVector(*near_null_space, Teuchos::Copy));
      hierarchy->GetLevel(0)->Set<RCP<XpetraVectors>>("Nullspace", wrap(vectors));
    }
    for (std::size_t k = 0; k < P.size(); ++k) {
      hierarchy->AddNewLevel();
      auto& level = *hierarchy->GetLevel(static_cast<int>(k) + 1);
      level.AddKeepFlag("P", MueLu::NoFactory::get(), MueLu::UserData);
      level.Set("P", P[k], MueLu::NoFactory::get());
    }
    interpreter.SetupHierarchy(*hierarchy);
  }

  RCP<const CrsMatrix> get(int level, char const* name) const
  {
    const auto wrapped = Teuchos::rcp_dynamic_cast<XpetraWrap>(
      hierarchy->GetLevel(level)->Get<RCP<XpetraMatrix>>(name), true);
    return Teuchos::rcp_dynamic_cast<XpetraTpetraMatrix>(wrapped->getCrsMatrix(), true)
      ->getTpetra_CrsMatrix();
  }

  Teuchos::ParameterList list;
  Interpreter interpreter;
  RCP<MueLu::Hierarchy<double, LocalOrdinal, GlobalOrdinal, Node>> hierarchy;
};

namespace
{
// A failure is due to the matrix or the list, except a lack of memory, which is passed on.
template <class Make>
auto asSolveError(Make const& make)
{
  try {
    return make();
  } catch (std::bad_alloc const&) {
    throw;
  } catch (std::exception const& error) {
    throw SolveError("MueLu cannot set up a multigrid hierarchy: " + usefulPart(error.what()) +
                     " Other parameters in the list MueLu, or 'Linear Correction' = Direct on one "
                     "rank, may help.");
  }
}
} // namespace

MueLuHierarchy::MueLuHierarchy(RCP<const CrsMatrix> const& A,
                               RCP<const MultiVector> const& near_null_space,
                               Teuchos::ParameterList const& muelu)
    : implementation_(asSolveError([&] {
      return std::make_unique<Implementation>(A, near_null_space, std::vector<RCP<XpetraMatrix>>(),
                                              muelu);
    }))
{
}

MueLuHierarchy::MueLuHierarchy(RCP<const CrsMatrix> const& A,
                               std::vector<RCP<const CrsMatrix>> const& P,
                               Teuchos::ParameterList const& muelu)
    : implementation_(asSolveError([&] {
      auto const wrapped = wrapAll(P);
      return std::make_unique<Implementation>(A, Teuchos::null, wrapped,
                                              withProlongators(muelu, wrapped));
    }))
{
}

MueLuHierarchy::~MueLuHierarchy() = default;
MueLuHierarchy::MueLuHierarchy(MueLuHierarchy&&) noexcept = default;
MueLuHierarchy& MueLuHierarchy::operator=(MueLuHierarchy&&) noexcept = default;

int MueLuHierarchy::numLevels() const { return implementation_->hierarchy->GetNumLevels(); }

RCP<const CrsMatrix> MueLuHierarchy::prolongator(int level) const
{
  return implementation_->get(level, "P");
}

RCP<const CrsMatrix> MueLuHierarchy::matrix(int level) const
{
  return implementation_->get(level, "A");
}

RCP<const MultiVector> MueLuHierarchy::nearNullSpace(int level) const
{
  auto const& self = *implementation_;
  auto const factory = self.interpreter.GetFactoryManager(level)->GetFactory("Nullspace");
  return Teuchos::rcp_dynamic_cast<XpetraTpetraVectors>(
           self.hierarchy->GetLevel(level)->Get<RCP<XpetraVectors>>("Nullspace", factory.get()),
           true)
    ->getTpetra_MultiVector();
}

void MueLuHierarchy::apply(MultiVector const& r, MultiVector& z) const
{
  const auto right_side =
    wrap(Teuchos::rcp_const_cast<MultiVector>(Teuchos::rcpFromRef(r))); // which it only reads
  z.putScalar(0);
  const auto iterate = wrap(Teuchos::rcpFromRef(z));
  constexpr int cycles = 1;
  constexpr bool begins_with_zero = true;
  implementation_->hierarchy->Iterate(*right_side, *iterate, cycles, begins_with_zero);
}
} // namespace asperity::tnnmg::detail
