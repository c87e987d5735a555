#include "dynamics/coupling/RateSolver.hpp"

#include "base/Errors.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/coupling/SharedMultigrid.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/DenseRateMatrix.hpp"
#include "tnnmg/SparseRateMatrix.hpp"
#include "tnnmg/direct/DenseCorrection.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Eigen/Core>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>

#include <optional>
#include <utility>

namespace asperity::dynamics
{
namespace
{
std::vector<int> rowsOf(fem::FaultSurface const& surface)
{
  std::vector<int> rows;
  for (auto const& node : surface) {
    rows.insert(rows.end(), node.dofs.begin(), node.dofs.end());
  }
  return rows;
}

// The fault without the body; the rows are those of rowsOf.
std::shared_ptr<const tnnmg::DenseRateMatrix> condensed(tnnmg::SchurComplement const& schur,
                                                        fem::FaultSurface const& surface)
{
  std::vector<int> held;
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      held.push_back(surface.held(node, k) ? 1 : 0);
    }
  }
  return std::make_shared<tnnmg::DenseRateMatrix>(schur.matrix(), schur.map(),
                                                  surface.numTangents(), held);
}

// Linear functionals N w of the minimiser w over all dofs but those of the fault, as functions of
// the velocity w_F of the fault: N w = (N_F - N_I Z_II^-1 Z_IF) w_F + N_I Z_II^-1 b_I. The matrix
// is full, and made once; the constant costs one triangular solve for each right side.
class CondensedFunctionals
{
public:
  CondensedFunctionals(tnnmg::SchurComplement const& schur, RCP<const CrsMatrix> const& N)
      : N_(N)
      , at_rest_(N->getDomainMap())
      , constant_(N->getRangeMap())
      , zero_(schur.map())
      , matrix_(numLocalRows(*N), numLocalElements(*schur.map()))
  {
    auto const local = N->getLocalMatrixHost();
    for (int row = 0; row < local.numRows(); ++row) {
      at_rest_.putScalar(0);
      {
        auto const values = at_rest_.getLocalViewHost(Tpetra::Access::ReadWrite);
        for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
          values(local.graph.entries(k), 0) = local.values(k);
        }
      }
      matrix_.row(row) = values(schur.condense(at_rest_).kept()).transpose();
    }
  }

  void begin(tnnmg::CondensedRightSide const& b)
  {
    b.expand(zero_, at_rest_);
    N_->apply(at_rest_, constant_);
  }

  void apply(Vector const& w_kept, NodeView const& r) const
  {
    auto const host = Kokkos::create_mirror_view(r);
    Eigen::Map<Eigen::VectorXd>(host.data(), host.extent_int(0)) =
      values(constant_) + matrix_ * values(w_kept);
    Kokkos::deep_copy(r, host);
  }

  std::size_t bytes() const { return sizeof(double) * static_cast<std::size_t>(matrix_.size()); }

private:
  static Eigen::VectorXd values(Vector const& x)
  {
    auto const view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    return Eigen::Map<const Eigen::VectorXd>(view.data(), static_cast<int>(view.extent(0)));
  }

  RCP<const CrsMatrix> N_;
  Vector at_rest_, constant_; // w where the fault is at rest; N of it
  Vector zero_;
  Eigen::MatrixXd matrix_;
};

// TNNMG on the fault's dofs or on all, as the derived class says.
class TnnmgRateSolver : public RateSolver
{
public:
  tnnmg::TnnmgResult solve(FrictionProblem const& problem) override
  {
    return tnnmg_.solve(problem);
  }
  tnnmg::TnnmgResult improve(FrictionProblem const& problem) override
  {
    return tnnmg_.improve(problem);
  }
  void faultVelocity(BlockView const& w) const override { Kokkos::deep_copy(w, tnnmg_.vAtNodes()); }

protected:
  TnnmgRateSolver(std::shared_ptr<const tnnmg::RateMatrix> const& Z,
                  std::shared_ptr<tnnmg::LinearCorrection> correction,
                  tnnmg::TnnmgSettings const& settings)
      : correction_(std::move(correction))
      , tnnmg_(Z, correction_, settings)
  {
  }

  void start(Vector const& b, Vector const& guess)
  {
    tnnmg_.begin(b, guess);
    correction_->reset();
  }
  Vector const& w() const { return tnnmg_.v(); }

private:
  std::shared_ptr<tnnmg::LinearCorrection> correction_;
  tnnmg::Tnnmg tnnmg_;
};

// All dofs but those of the fault are eliminated, exactly, before and after TNNMG runs on the
// fault.
class CondensedRateSolver final : public TnnmgRateSolver
{
public:
  CondensedRateSolver(tnnmg::SchurComplement schur,
                      std::shared_ptr<const tnnmg::DenseRateMatrix> const& S,
                      std::shared_ptr<tnnmg::DenseCorrection> const& correction,
                      std::vector<int> rows, tnnmg::TnnmgSettings const& settings,
                      RCP<const CrsMatrix> const& reactions)
      : TnnmgRateSolver(S, correction, settings)
      , schur_(std::move(schur))
      , correction_(correction)
      , rows_(std::move(rows))
  {
    if (!reactions.is_null()) {
      reactions_.emplace(schur_, reactions);
    }
  }

  void begin(Vector const& b, Vector const& guess) override
  {
    ASPERITY_TIME_WORK("elimination of the body");
    condensed_ = schur_.condense(b);
    if (reactions_) {
      reactions_->begin(*condensed_);
    }
    Vector at_fault(schur_.map());
    {
      auto const from = guess.getLocalViewHost(Tpetra::Access::ReadOnly);
      auto const to = at_fault.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        to(i, 0) = from(rows_[i], 0);
      }
    }
    start(condensed_->kept(), at_fault);
  }

  void velocity(Vector& w_all) const override
  {
    ASPERITY_TIME_WORK("elimination of the body");
    condensed_->expand(w(), w_all);
  }
  void knownVelocity(Vector& w_all) const override
  {
    auto const from = w().getLocalViewHost(Tpetra::Access::ReadOnly);
    auto const to = w_all.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      to(rows_[i], 0) = from(i, 0);
    }
  }
  void reactions(NodeView const& r) const override
  {
    ASPERITY_ASSERT(reactions_);
    reactions_->apply(w(), r);
  }
  std::size_t bytes() const override
  {
    return schur_.bytes() + correction_->bytes() + (reactions_ ? reactions_->bytes() : 0);
  }

private:
  tnnmg::SchurComplement schur_;
  std::shared_ptr<const tnnmg::DenseCorrection> correction_;
  std::vector<int> rows_;
  std::optional<tnnmg::CondensedRightSide> condensed_; // of the present b
  std::optional<CondensedFunctionals> reactions_;
};

// TNNMG on all dofs of all ranks.
class FullRateSolver final : public TnnmgRateSolver
{
public:
  FullRateSolver(RCP<const CrsMatrix> const& Z, tnnmg::NonlinearNodes const& nodes,
                 std::shared_ptr<tnnmg::MultigridCorrection> const& correction,
                 tnnmg::TnnmgSettings const& settings, RCP<const CrsMatrix> const& reactions)
      : TnnmgRateSolver(std::make_shared<tnnmg::SparseRateMatrix>(Z, nodes), correction, settings)
      , Z_(Z)
      , reactions_(reactions)
      , correction_(correction)
  {
  }

  void begin(Vector const& b, Vector const& guess) override { start(b, guess); }
  void velocity(Vector& w_all) const override { Tpetra::deep_copy(w_all, w()); }
  void knownVelocity(Vector& w_all) const override { velocity(w_all); }
  void reactions(NodeView const& r) const override
  {
    ASPERITY_ASSERT(!reactions_.is_null());
    Vector result(reactions_->getRangeMap());
    reactions_->apply(w(), result);
    auto const values = result.getLocalViewDevice(Tpetra::Access::ReadOnly);
    Kokkos::deep_copy(r, Kokkos::subview(values, Kokkos::ALL, 0));
  }
  // Z's values, the preconditioner, and some twenty vectors.
  std::size_t bytes() const override
  {
    return 8 * numLocalEntries(*Z_) + correction_->bytes() + 20 * 8 * numLocalRows(*Z_);
  }

private:
  RCP<const CrsMatrix> Z_, reactions_;
  std::shared_ptr<const tnnmg::MultigridCorrection> correction_;
};
} // namespace

std::unique_ptr<RateSolver> makeRateSolver(RCP<const CrsMatrix> const& Z, Body const& body,
                                           fem::FaultSurface const& surface,
                                           RateSolverSettings const& settings,
                                           RCP<const CrsMatrix> const& reactions,
                                           SharedSetup const& shared)
{
  if (settings.correction == Correction::direct) {
    tnnmg::EliminationOrder own;
    auto rows = rowsOf(surface);
    tnnmg::SchurComplement schur(*Z, rows, shared.order ? *shared.order : own);
    auto const S = condensed(schur, surface);
    auto const correction = std::make_shared<tnnmg::DenseCorrection>(S->entries(), S->nodes().dofs);
    return std::make_unique<CondensedRateSolver>(std::move(schur), S, correction, std::move(rows),
                                                 settings.tnnmg, reactions);
  }
  auto const nodes = nodesOf(surface);
  auto const correction = std::make_shared<tnnmg::MultigridCorrection>(
    multigridProblem(Z, body, nodes), settings.multigrid, shared.terms, shared.weights);
  return std::make_unique<FullRateSolver>(Z, nodes, correction, settings.tnnmg, reactions);
}
} // namespace asperity::dynamics
