#pragma once

#include "dynamics/rate/RateSolver.hpp"
#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/RateMatrix.hpp"

#include <memory>
#include <utility>

namespace asperity::dynamics
{
// A rate solver that runs TNNMG on the fault's dofs or on all, as the derived class says.
class TnnmgRateSolver : public RateSolver
{
public:
  tnnmg::TnnmgResult solve(tnnmg::NodalProblem const& problem) override
  {
    return tnnmg_.solve(problem);
  }
  tnnmg::TnnmgResult improve(tnnmg::NodalProblem const& problem) override
  {
    return tnnmg_.improve(problem);
  }
  void faultVelocity(BlockView const& w) const override
  {
    auto const& all = tnnmg_.vAtNodes();
    if (all.extent(1) == w.extent(1)) {
      Kokkos::deep_copy(w, all);
    } else {
      Kokkos::deep_copy(w, Kokkos::subview(all, Kokkos::ALL, std::pair(0, w.extent_int(1))));
    }
  }

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
} // namespace asperity::dynamics
