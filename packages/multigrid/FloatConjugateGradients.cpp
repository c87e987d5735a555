#include "multigrid/FloatConjugateGradients.hpp"

#include "multigrid/FlushDenormals.hpp"

#include <array>
#include <utility>

namespace asperity::multigrid
{
namespace
{
// Inner products of r, z, w = (Z + H) z and the last s.
struct Products
{
  double rr, rz, zw, rw, ww, ws, rs, ss;
};

// N numbers in each row.
Products productsOf(Chunks const& chunks, int N, NodeVector const& r, Cycle::Result const& cycle,
                    NodeVector const& s, SumOverRanks const& sumOverRanks)
{
  auto sums = chunks.sum<8>([&](int begin, int end, std::array<double, 8>& all) {
    auto [rr, rz, zw, rw, ww, ws, rs, ss] = all;
    for (int i = begin * N; i < end * N; ++i) {
      const double ri = r[i], zi = cycle.z[i], wi = cycle.image[i], si = s[i];
      rr += ri * ri;
      rz += ri * zi;
      zw += zi * wi;
      rw += ri * wi;
      ww += wi * wi;
      ws += wi * si;
      rs += ri * si;
      ss += si * si;
    }
    all = {rr, rz, zw, rw, ww, ws, rs, ss};
  });
  sumOverRanks(sums.data(), 8);
  auto const [rr, rz, zw, rw, ww, ws, rs, ss] = sums;
  return {rr, rz, zw, rw, ww, ws, rs, ss};
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
  auto const& chunks = cycle_.chunks();
  const int N = cycle_.rowSize();
  const auto forEach = [&](auto const& work) {
    chunks.forEach([&](int begin, int end) {
      for (int i = begin * N; i < end * N; ++i) {
        work(i);
      }
    });
  };
  if (norm > 0) {
    forEach([&](int i) { r_[i] = static_cast<float>(right_side(i) / norm); });
  }
  const double target = relative_tolerance * relative_tolerance;
  double before = 0, step = 0;
  result.converged = !(norm > 0);
  while (!result.converged && result.iterations < max_iterations) {
    auto const cycle = cycle_.run(r_, true);
    auto const now = productsOf(chunks, N, r_, cycle, s_, sum_);
    const double again = result.iterations > 0 ? now.rz / before : 0;
    const double curvature = now.zw - (result.iterations > 0 ? again * now.rz / step : 0);
    if (!(now.rz > 0 && curvature > 0)) {
      break;
    }
    step = now.rz / curvature;
    before = now.rz;
    ++result.iterations;
    forEach([&](int i) {
      p_[i] = cycle.z[i] + static_cast<float>(again) * p_[i];
      s_[i] = cycle.image[i] + static_cast<float>(again) * s_[i];
      c_[i] += static_cast<float>(step) * p_[i];
      r_[i] -= static_cast<float>(step) * s_[i];
    });
    const double rs = now.rw + again * now.rs;
    const double ss = now.ww + 2 * again * now.ws + again * again * now.ss;
    result.converged = now.rr - 2 * step * rs + step * step * ss <= target;
  }
  forEach([&](int i) { c(i) = norm > 0 ? norm * c_[i] : 0; });
  return result;
}
} // namespace asperity::multigrid
