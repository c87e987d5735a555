#include "dynamics/rate/CondensedRateSolver.hpp"

#include "base/Errors.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/rate/CondensedFunctionals.hpp"
#include "dynamics/rate/TnnmgRateSolver.hpp"
#include "tnnmg/DenseRateMatrix.hpp"
#include "tnnmg/direct/DenseCorrection.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace asperity::dynamics
{
namespace
{
std::vector<int> rowsOf(fem::FaultSurface const& surface)
{
  std::vector<int> rows;
  for (int node = 0; node < surface.numNodes(); ++node) {
    auto const unknowns = surface.unknownsOf(node);
    rows.insert(rows.end(), unknowns.begin(), unknowns.end());
  }
  return rows;
}

// The fault without the body; the rows are those of rowsOf.
std::shared_ptr<const tnnmg::DenseRateMatrix> condensed(tnnmg::SchurComplement const& schur,
                                                        fem::FaultSurface const& surface)
{
  std::vector<int> held;
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (const int dof : surface.unknownsOf(node)) {
      held.push_back(surface.isHeld(dof) ? 1 : 0);
    }
  }
  return std::make_shared<tnnmg::DenseRateMatrix>(schur.matrix(), schur.map(),
                                                  surface.numUnknowns(), held);
}

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
} // namespace

std::unique_ptr<RateSolver> makeCondensedRateSolver(CrsMatrix const& Z,
                                                    fem::FaultSurface const& surface,
                                                    tnnmg::TnnmgSettings const& settings,
                                                    RCP<const CrsMatrix> const& reactions,
                                                    tnnmg::EliminationOrder& order)
{
  auto rows = rowsOf(surface);
  tnnmg::SchurComplement schur(Z, rows, order);
  auto const S = condensed(schur, surface);
  auto const correction = std::make_shared<tnnmg::DenseCorrection>(S->entries(), S->nodes().dofs);
  return std::make_unique<CondensedRateSolver>(std::move(schur), S, correction, std::move(rows),
                                               settings, reactions);
}
} // namespace asperity::dynamics
