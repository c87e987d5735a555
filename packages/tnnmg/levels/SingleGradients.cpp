#include "tnnmg/levels/SingleGradients.hpp"

#include "base/parallel/Reductions.hpp"
#include "tnnmg/levels/FlushDenormals.hpp"

#include <Tpetra_Vector.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
// Inner products of r, z, w = (Z + H) z and the last s.
struct Products
{
  double rr = 0, rz = 0, zw = 0, rw = 0, ww = 0, ws = 0, rs = 0, ss = 0;
};

Products productsOf(NodeVector const& r, NodeVector const& z, NodeVector const& w,
                    NodeVector const& s, Communicator const& communicator)
{
  Products mine;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double ri = r[i], zi = z[i], wi = w[i], si = s[i];
    mine.rr += ri * ri;
    mine.rz += ri * zi;
    mine.zw += zi * wi;
    mine.rw += ri * wi;
    mine.ww += wi * wi;
    mine.ws += wi * si;
    mine.rs += ri * si;
    mine.ss += si * si;
  }
  const std::array<double, 8> sums = {mine.rr, mine.rz, mine.zw, mine.rw,
                                      mine.ww, mine.ws, mine.rs, mine.ss};
  const auto all = sumOverRanks(sums, communicator);
  return {all[0], all[1], all[2], all[3], all[4], all[5], all[6], all[7]};
}
} // namespace

SingleGradients::SingleGradients(MultigridCycle const& cycle, RCP<const Communicator> communicator)
    : cycle_(cycle)
    , communicator_(std::move(communicator))
{
}

IterationResult SingleGradients::solve(Vector const& right_side, double relative_tolerance,
                                       int max_iterations, Vector& c) const
{
  const FlushDenormals flushed;
  IterationResult result;
  const double norm = right_side.norm2();
  auto& r = cycle_.r();
  c_.assign(r.size(), 0.f);
  p_.assign(r.size(), 0.f);
  s_.assign(r.size(), 0.f);
  if (norm > 0) {
    auto const values = right_side.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] = static_cast<float>(values(i, 0) / norm);
    }
  }
  const double target = relative_tolerance * relative_tolerance;
  double before = 0, step = 0;
  result.converged = !(norm > 0);
  while (!result.converged && result.iterations < max_iterations) {
    cycle_.run(true);
    auto const& z = cycle_.z();
    auto const& w = cycle_.image();
    auto const now = productsOf(r, z, w, s_, *communicator_);
    const double again = result.iterations > 0 ? now.rz / before : 0;
    const double curvature = now.zw - (result.iterations > 0 ? again * now.rz / step : 0);
    if (!(now.rz > 0 && curvature > 0)) {
      break;
    }
    step = now.rz / curvature;
    before = now.rz;
    ++result.iterations;
    for (std::size_t i = 0; i < r.size(); ++i) {
      p_[i] = z[i] + static_cast<float>(again) * p_[i];
      s_[i] = w[i] + static_cast<float>(again) * s_[i];
      c_[i] += static_cast<float>(step) * p_[i];
      r[i] -= static_cast<float>(step) * s_[i];
    }
    const double rs = now.rw + again * now.rs;
    const double ss = now.ww + 2 * again * now.ws + again * again * now.ss;
    result.converged = now.rr - 2 * step * rs + step * step * ss <= target;
  }
  auto const values = c.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < r.size(); ++i) {
    values(i, 0) = norm > 0 ? norm * c_[i] : 0;
  }
  return result;
}
} // namespace asperity::tnnmg::detail
