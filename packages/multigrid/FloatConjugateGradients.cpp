#include "multigrid/FloatConjugateGradients.hpp"

#include "multigrid/FlushDenormals.hpp"
#include "multigrid/NodeKernels.hpp"

#include <utility>

namespace asperity::multigrid
{
namespace
{
// The products rr, rz, zw, rw, ww, ws, rs, ss of r, z, w = (Z + H) z and the last s.
struct InnerProducts
{
  using value_type = double[]; // NOLINT(modernize-avoid-c-arrays): as Kokkos wants it
  static constexpr int num_products = 8;
  unsigned value_count = num_products;

  float const *r, *z, *w, *s;
  KOKKOS_FUNCTION void operator()(int i, double* sums) const
  {
    add<double>(r[i], z[i], w[i], s[i], sums);
  }
  // All from `begin` to `end`, on the host: in single precision as long as few are added.
  void addRange(int begin, int end, double* sums) const
  {
    constexpr int few = 64;
    int i = begin;
    while (i + num_lanes <= end) {
      Lanes parts[num_products] = {};
      for (int k = 0; k < few && i + num_lanes <= end; ++k, i += num_lanes) {
        add(load(r + i), load(z + i), load(w + i), load(s + i), parts);
      }
      for (int n = 0; n < num_products; ++n) {
        sums[n] += total(parts[n]);
      }
    }
    for (; i < end; ++i) {
      (*this)(i, sums);
    }
  }
  template <class Number>
  static KOKKOS_FUNCTION void add(Number ri, Number zi, Number wi, Number si, Number* sums)
  {
    sums[0] += ri * ri;
    sums[1] += ri * zi;
    sums[2] += zi * wi;
    sums[3] += ri * wi;
    sums[4] += wi * wi;
    sums[5] += wi * si;
    sums[6] += ri * si;
    sums[7] += si * si;
  }
};

// The next direction and its image, and what follows from a step along it.
struct Advance
{
  float beta, step;
  float const *z, *w;
  float *p, *s, *c, *r;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    p[i] = z[i] + beta * p[i];
    s[i] = w[i] + beta * s[i];
    c[i] += step * p[i];
    r[i] -= step * s[i];
  }
};
} // namespace

FloatConjugateGradients::FloatConjugateGradients(Cycle& cycle, SumOverRanks sum)
    : cycle_(cycle)
    , sum_(std::move(sum))
    , r_(makeNumbers(cycle.rows()))
    , c_(makeNumbers(cycle.rows()))
    , p_(makeNumbers(cycle.rows()))
    , s_(makeNumbers(cycle.rows()))
{
}

IterationResult FloatConjugateGradients::solve(ConstNodeView const& right_side, double norm,
                                               double relative_tolerance, int max_iterations,
                                               NodeView const& c)
{
  const FlushDenormals flushed;
  IterationResult result;
  for (auto const& x : {c_, p_, s_}) {
    Kokkos::deep_copy(x, 0.f);
  }
  auto const& schedule = cycle_.schedule();
  const int N = cycle_.rowSize();
  if (norm > 0) {
    cycle_.toRows(right_side, norm, r_);
  }
  const double target = relative_tolerance * relative_tolerance;
  double before = 0, step = 0;
  result.converged = !(norm > 0);
  while (!result.converged && result.iterations < max_iterations) {
    auto const cycle = cycle_.run(r_, true);
    float const *z = cycle.z.data(), *w = cycle.image.data();
    auto sums = schedule.sum<InnerProducts::num_products>(
      N, InnerProducts{InnerProducts::num_products, r_.data(), z, w, s_.data()});
    sum_(sums.data(), InnerProducts::num_products);
    auto const [rr, rz, zw, rw, ww, ws, rs_before, ss_before] = sums;
    const double beta = result.iterations > 0 ? rz / before : 0;
    const double curvature = zw - (result.iterations > 0 ? beta * rz / step : 0);
    if (!(rz > 0 && curvature > 0)) {
      break;
    }
    step = rz / curvature;
    before = rz;
    ++result.iterations;
    schedule.forEachNumber(N, Advance{static_cast<float>(beta), static_cast<float>(step), z, w,
                                      p_.data(), s_.data(), c_.data(), r_.data()});
    const double rs = rw + beta * rs_before;
    const double ss = ww + 2 * beta * ws + beta * beta * ss_before;
    result.converged = rr - 2 * step * rs + step * step * ss <= target;
  }
  if (norm > 0) {
    cycle_.fromRows(c_, norm, c);
  } else {
    Kokkos::deep_copy(c, 0.);
  }
  return result;
}
} // namespace asperity::multigrid
