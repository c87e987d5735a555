#include "tnnmg/correction/MultigridCorrection.hpp"

#include "base/Errors.hpp"
#include "tnnmg/correction/BelosConjugateGradients.hpp"
#include "tnnmg/hierarchy/TrilinosMessages.hpp"

#include <MueLu_VerboseObject.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <exception>
#include <new>
#include <string>

namespace asperity::tnnmg
{
namespace
{
constexpr int length = 64;

// The stiffness of a chain of springs, antiplane, with a weak support at each node.
RCP<const CrsMatrix> chain()
{
  const RCP<const Communicator> alone = rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF));
  const RCP<const Map> map = rcp(new Map(length, 0, alone));
  const auto Z = rcp(new CrsMatrix(map, 3));
  for (int row = 0; row < length; ++row) {
    for (int column = std::max(row - 1, 0); column <= std::min(row + 1, length - 1); ++column) {
      const GlobalOrdinal id = column;
      const double value = row == column ? 2.1 : -1;
      Z->insertGlobalValues(row, 1, &value, &id);
    }
  }
  Z->fillComplete();
  return Z;
}

MultigridProblem chainProblem()
{
  MultigridProblem problem;
  problem.Z = chain();
  problem.components = 1;
  const auto translation = rcp(new MultiVector(problem.Z->getRowMap(), 1));
  translation->putScalar(1);
  problem.near_null_space = translation;
  problem.nodes.dofs =
    Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace>("asperity::tnnmg::trial", 0, 1);
  return problem;
}

// While it lives, MueLu prints nothing: when it refuses a name, it prints all names that it knows.
class SilentMueLu
{
public:
  SilentMueLu() : stream_(MueLu::VerboseObject::GetMueLuOStream())
  {
    MueLu::VerboseObject::SetMueLuOStream(
      Teuchos::getFancyOStream(rcp(new Teuchos::oblackholestream)));
  }
  ~SilentMueLu() { MueLu::VerboseObject::SetMueLuOStream(stream_); }
  SilentMueLu(SilentMueLu const&) = delete;
  SilentMueLu& operator=(SilentMueLu const&) = delete;

private:
  RCP<Teuchos::FancyOStream> stream_;
};

bool hasEntries(Teuchos::ParameterList const& parameters, std::string const& name)
{
  return parameters.isSublist(name) && parameters.sublist(name).numParams() > 0;
}
} // namespace

void MultigridCorrection::requireAccepted(Teuchos::ParameterList const& parameters)
{
  const bool muelu = hasEntries(parameters, "MueLu");
  if (!muelu && !hasEntries(parameters, "Belos")) {
    return;
  }
  Teuchos::ParameterList list(parameters);
  list.sublist("MueLu").set("coarse: max size", 4); // several levels in a small model
  try {
    const SilentMueLu silent;
    detail::checkBelosParameters(parameters.isSublist("Belos") ? parameters.sublist("Belos")
                                                               : Teuchos::ParameterList());
    const auto problem = chainProblem();
    MultigridCorrection correction(problem, list);
    Vector b(problem.Z->getRowMap()), x(problem.Z->getRowMap());
    b.putScalar(1);
    correction.solve({}, b, 1e-6, x);
  } catch (std::bad_alloc const&) {
    throw;
  } catch (std::exception const& error) {
    throw InputError("Asperity / TNNMG / Multigrid: a small problem was not solved with "
                     "the lists MueLu and Belos of the deck. " +
                     detail::usefulPart(error.what()) + " Correct the lists or leave them out.");
  }
}
} // namespace asperity::tnnmg
