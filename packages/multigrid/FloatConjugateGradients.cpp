#include "multigrid/FloatConjugateGradients.hpp"

#include "multigrid/FlushDenormals.hpp"

#include <utility>

namespace asperity::multigrid
{
namespace
{
// Inner products of r, z, w = (Z + H) z and the last s.
struct Products
{
  double rr = 0, rz = 0, zw = 0, rw = 0, ww = 0, ws = 0, rs = 0, ss = 0;
};

Products productsOf(NodeVector const& r, Cycle::Result const& cycle, NodeVector const& s,
                    SumOverRanks const& sumOverRanks)
{
  Products sums;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double ri = r[i], zi = cycle.z[i], wi = cycle.image[i], si = s[i];
    sums.rr += ri * ri;
    sums.rz += ri * zi;
    sums.zw += zi * wi;
    sums.rw += ri * wi;
    sums.ww += wi * wi;
    sums.ws += wi * si;
    sums.rs += ri * si;
    sums.ss += si * si;
  }
  double all[8] = {sums.rr, sums.rz, sums.zw, sums.rw, sums.ww, sums.ws, sums.rs, sums.ss};
  sumOverRanks(all, 8);
  return {all[0], all[1], all[2], all[3], all[4], all[5], all[6], all[7]};
}
} // namespace

FloatConjugateGradients::FloatConjugateGradients(Cycle& cycle, SumOverRanks sum)
    : cycle_(cycle)
    , sum_(std::move(sum))
    , r_(cycle.rows())
{
}

IterationResult FloatConjugateGradients::solve(HostView<const double*> const& right_side,
                                               double norm, double relative_tolerance,
                                               int max_iterations, HostView<double*> const& c)
{
  const FlushDenormals flushed;
  IterationResult result;
  c_.assign(r_.size(), 0.f);
  p_.assign(r_.size(), 0.f);
  s_.assign(r_.size(), 0.f);
  for (std::size_t i = 0; norm > 0 && i < r_.size(); ++i) {
    r_[i] = static_cast<float>(right_side(i) / norm);
  }
  const double target = relative_tolerance * relative_tolerance;
  double before = 0, step = 0;
  result.converged = !(norm > 0);
  while (!result.converged && result.iterations < max_iterations) {
    auto const cycle = cycle_.run(r_, true);
    auto const now = productsOf(r_, cycle, s_, sum_);
    const double again = result.iterations > 0 ? now.rz / before : 0;
    const double curvature = now.zw - (result.iterations > 0 ? again * now.rz / step : 0);
    if (!(now.rz > 0 && curvature > 0)) {
      break;
    }
    step = now.rz / curvature;
    before = now.rz;
    ++result.iterations;
    for (std::size_t i = 0; i < r_.size(); ++i) {
      p_[i] = cycle.z[i] + static_cast<float>(again) * p_[i];
      s_[i] = cycle.image[i] + static_cast<float>(again) * s_[i];
      c_[i] += static_cast<float>(step) * p_[i];
      r_[i] -= static_cast<float>(step) * s_[i];
    }
    const double rs = now.rw + again * now.rs;
    const double ss = now.ww + 2 * again * now.ws + again * again * now.ss;
    result.converged = now.rr - 2 * step * rs + step * step * ss <= target;
  }
  for (std::size_t i = 0; i < r_.size(); ++i) {
    c(i) = norm > 0 ? norm * c_[i] : 0;
  }
  return result;
}
} // namespace asperity::multigrid
