#include "dynamics/rate/FullRateSolver.hpp"

#include "base/Errors.hpp"
#include "dynamics/rate/TnnmgRateSolver.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/SparseRateMatrix.hpp"

#include <Tpetra_CrsMatrix.hpp>

namespace asperity::dynamics
{
namespace
{
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

std::unique_ptr<RateSolver>
makeFullRateSolver(RCP<const CrsMatrix> const& Z, tnnmg::NonlinearNodes const& nodes,
                   std::shared_ptr<tnnmg::MultigridCorrection> const& correction,
                   tnnmg::TnnmgSettings const& settings, RCP<const CrsMatrix> const& reactions)
{
  return std::make_unique<FullRateSolver>(Z, nodes, correction, settings, reactions);
}
} // namespace asperity::dynamics
