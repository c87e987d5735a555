#include "compare/LinearReference.hpp"

#include "base/Errors.hpp"

#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <MueLu_CreateTpetraPreconditioner.hpp>

#include <cmath>

using namespace asperity;

using Operator = Tpetra::Operator<double, LocalOrdinal, GlobalOrdinal>;
using LinearProblem = Belos::LinearProblem<double, MultiVector, Operator>;

struct LinearReference::Implementation
{
  RCP<const CrsMatrix> Z;
  RCP<Operator> preconditioner;
};

LinearReference::LinearReference(RCP<const CrsMatrix> const& Z, dynamics::Body const& body)
    : implementation_(std::make_unique<Implementation>())
{
  const auto motions = rcp(new MultiVector(*body.near_null_space, Teuchos::Copy));
  {
    const auto values = motions->getLocalViewHost(Tpetra::Access::ReadWrite);
    const auto rows =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body.held.ownedOnDevice());
    for (int k = 0; k < rows.extent_int(0); ++k) {
      for (int column = 0; column < values.extent_int(1); ++column) {
        values(rows(k), column) *= 1e-8; // MueLu refuses all 0 on an aggregate
      }
    }
  }
  Teuchos::ParameterList list("MueLu");
  list.set("verbosity", "none");
  list.set("number of equations", body.dofs->components());
  list.set("rap: fix zero diagonals", true);
  list.sublist("user data").set("Nullspace", motions);
  implementation_->Z = Z;
  const RCP<Operator> fine = Teuchos::rcp_const_cast<CrsMatrix>(Z);
  implementation_->preconditioner = MueLu::CreateTpetraPreconditioner(fine, list);
}

LinearReference::~LinearReference() = default;

void LinearReference::iterate(Vector const& b, int num_iterations, Vector& x) const
{
  x.putScalar(0);
  const auto problem =
    rcp(new LinearProblem(implementation_->Z, Teuchos::rcpFromRef(x), Teuchos::rcpFromRef(b)));
  problem->setRightPrec(implementation_->preconditioner);
  problem->setProblem();
  const auto list = rcp(new Teuchos::ParameterList);
  list->set("Maximum Iterations", num_iterations);
  list->set("Convergence Tolerance", 1e-15);
  Belos::PseudoBlockCGSolMgr<double, MultiVector, Operator>(problem, list).solve();
}

int LinearReference::iterationsFor(Vector const& b, Vector const& solution, double error) const
{
  Vector x(b.getMap());
  for (int count = 1; count < 200; ++count) {
    iterate(b, count, x);
    x.update(-1, solution, 1);
    if (energyNorm(*implementation_->Z, x) <= error) {
      return count;
    }
  }
  throw SolveError("The linear problem for comparison is not solved in 200 iterations.");
}

double energyNorm(CrsMatrix const& Z, Vector const& x)
{
  Vector image(x.getMap());
  Z.apply(x, image);
  return std::sqrt(std::max(image.dot(x), 0.));
}
