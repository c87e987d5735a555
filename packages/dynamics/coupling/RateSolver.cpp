#include "dynamics/coupling/RateSolver.hpp"

#include "base/Errors.hpp"
#include "base/program/WorkTimers.hpp"
#include "tnnmg/DenseCorrection.hpp"
#include "tnnmg/MueLuCorrection.hpp"
#include "tnnmg/SchurComplement.hpp"

#include <Tpetra_Map.hpp>

namespace asperity::dynamics
{
namespace
{
using Solver = tnnmg::Tnnmg<FrictionProblem>;

std::vector<int> rowsOf(fem::FaultSurface const& surface)
{
  std::vector<int> rows;
  for (auto const& node : surface) {
    rows.insert(rows.end(), node.dofs.begin(), node.dofs.end());
  }
  return rows;
}

// The fault's nodes in the condensed matrix, whose rows are those of rowsOf.
tnnmg::NonlinearNodes condensedNodes(fem::FaultSurface const& surface)
{
  std::vector<int> held;
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      held.push_back(surface.held(node, k) ? 1 : 0);
    }
  }
  return tnnmg::coupledNodes(surface.numNodes(), surface.numTangents(), held);
}

tnnmg::NonlinearNodes nodesOf(fem::FaultSurface const& surface)
{
  return {surface.dofs(), surface.heldDofs(), surface.colours()};
}

// All dofs but those of the fault are eliminated, exactly, before and after TNNMG runs on the
// fault.
class CondensedRateSolver final : public RateSolver
{
public:
  CondensedRateSolver(CrsMatrix const& Z, fem::FaultSurface const& surface,
                      tnnmg::TnnmgSettings const& settings)
      : schur_(Z, rowsOf(surface))
      , nodes_(condensedNodes(surface))
      , correction_(std::make_shared<tnnmg::DenseCorrection>(*schur_.matrix(), nodes_.dofs))
      , tnnmg_(schur_.matrix(), nodes_, correction_, settings)
      , rows_(rowsOf(surface))
      , b_(schur_.matrix()->getDomainMap())
      , w_(schur_.matrix()->getDomainMap())
  {
  }

  void begin(Vector const& b, Vector const& guess) override
  {
    ASPERITY_TIME_WORK("elimination of the body");
    schur_.condense(b, b_);
    auto const from = guess.getLocalViewHost(Tpetra::Access::ReadOnly);
    auto const to = w_.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      to(i, 0) = from(rows_[i], 0);
    }
    correction_->reset();
  }

  tnnmg::TnnmgResult solve(FrictionProblem const& problem) override
  {
    return tnnmg_.solve(problem, b_, w_);
  }
  tnnmg::TnnmgResult improve(FrictionProblem const& problem) override
  {
    return tnnmg_.improve(problem, b_, w_);
  }

  void faultVelocity(friction::BlockView const& w) const override { gather(nodes_, w_, w); }
  void velocity(Vector& w) const override
  {
    ASPERITY_TIME_WORK("elimination of the body");
    schur_.expand(w_, w);
  }
  std::size_t bytes() const override { return schur_.bytes() + correction_->bytes(); }

private:
  tnnmg::SchurComplement schur_;
  tnnmg::NonlinearNodes nodes_;
  std::shared_ptr<tnnmg::DenseCorrection> correction_;
  Solver tnnmg_;
  std::vector<int> rows_;
  Vector b_, w_;
};

tnnmg::MultigridProblem multigridProblem(RCP<const CrsMatrix> const& Z, Body const& body,
                                         tnnmg::NonlinearNodes const& nodes)
{
  return {Z, body.dofs->components(), body.near_null_space, body.held.ownedOnDevice(), nodes};
}

// TNNMG on all dofs of all ranks.
class FullRateSolver final : public RateSolver
{
public:
  FullRateSolver(RCP<const CrsMatrix> const& Z, Body const& body, fem::FaultSurface const& surface,
                 RateSolverSettings const& settings)
      : Z_(Z)
      , nodes_(nodesOf(surface))
      , correction_(std::make_shared<tnnmg::MueLuCorrection>(multigridProblem(Z, body, nodes_),
                                                             settings.multigrid))
      , tnnmg_(Z, nodes_, correction_, settings.tnnmg)
      , b_(Z->getDomainMap())
      , w_(Z->getDomainMap())
  {
  }

  void begin(Vector const& b, Vector const& guess) override
  {
    Tpetra::deep_copy(b_, b);
    Tpetra::deep_copy(w_, guess);
    correction_->reset();
  }

  tnnmg::TnnmgResult solve(FrictionProblem const& problem) override
  {
    return tnnmg_.solve(problem, b_, w_);
  }
  tnnmg::TnnmgResult improve(FrictionProblem const& problem) override
  {
    return tnnmg_.improve(problem, b_, w_);
  }

  void faultVelocity(friction::BlockView const& w) const override { gather(nodes_, w_, w); }
  void velocity(Vector& w) const override { Tpetra::deep_copy(w, w_); }
  // A hierarchy weighs about as much as two copies of its matrix.
  std::size_t bytes() const override { return 3 * 12 * Z_->getNodeNumEntries(); }

private:
  RCP<const CrsMatrix> Z_;
  tnnmg::NonlinearNodes nodes_;
  std::shared_ptr<tnnmg::MueLuCorrection> correction_;
  Solver tnnmg_;
  Vector b_, w_;
};
} // namespace

std::unique_ptr<RateSolver> makeRateSolver(RCP<const CrsMatrix> const& Z, Body const& body,
                                           fem::FaultSurface const& surface,
                                           RateSolverSettings const& settings)
{
  if (settings.correction == Correction::direct) {
    return std::make_unique<CondensedRateSolver>(*Z, surface, settings.tnnmg);
  }
  return std::make_unique<FullRateSolver>(Z, body, surface, settings);
}

namespace
{
// Rounding makes the factor of a singular matrix: its answer solves nothing.
void requireSolution(CrsMatrix const& Z, Vector const& b, Vector const& x)
{
  Vector rest(b, Teuchos::Copy);
  Z.apply(x, rest, Teuchos::NO_TRANS, -1, 1);
  if (!(rest.norm2() <= 1e-6 * b.norm2())) {
    throw SolveError("The static problem has no solution: some part of the body can move without "
                     "resistance. Check that the boundary conditions hold it.");
  }
}
} // namespace

void solveLinear(RCP<const CrsMatrix> const& Z, Body const& body,
                 RateSolverSettings const& settings, Vector const& b, Vector& x)
{
  if (settings.correction == Correction::direct) {
    tnnmg::SchurComplement factor(*Z, {});
    Vector nothing(factor.matrix()->getDomainMap());
    factor.condense(b, nothing);
    factor.expand(nothing, x);
    requireSolution(*Z, b, x);
    return;
  }
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> none(
    "asperity::dynamics::none", 0, 1);
  Teuchos::ParameterList list(settings.multigrid);
  list.set("Method", "CG");      // a few cycles are for corrections, not for the last digits
  list.set("Hierarchy", "Keep"); // without friction there is nothing to follow
  tnnmg::MueLuCorrection multigrid(multigridProblem(Z, body, {none, body.held.flagsOnDevice(), {}}),
                                   list);
  auto const result = multigrid.solve({}, b, 1e-12, x);
  if (!result.converged) {
    std::ostringstream message;
    message << "The static problem was not solved: conjugate gradients stopped after "
            << result.iterations
            << " iterations. Check that the boundary conditions hold the body, "
            << "and raise the iteration limit in TNNMG / MueLu Correction.";
    throw SolveError(message.str());
  }
}
} // namespace asperity::dynamics
