#include "RoughNodes.hpp"

#include <Kokkos_Core.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::tnnmg::test
{
namespace
{
using Block = std::vector<double>;

template <class View>
Block blockAt(View const& view, std::size_t node)
{
  Block block;
  for (std::size_t k = 0; k < view.extent(1); ++k) {
    block.push_back(view(node, k));
  }
  return block;
}

double dot(Block const& a, Block const& b)
{
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += a[k] * b[k];
  }
  return sum;
}

double norm(Block const& a) { return std::sqrt(dot(a, a)); }

Block along(Block a, double t, Block const& d)
{
  for (std::size_t k = 0; k < a.size(); ++k) {
    a[k] += t * d[k];
  }
  return a;
}

// Between V and V + h, the integral of asinh(. / scale) is a plain difference of two values.
bool isFar(double V, double h, double scale) { return std::abs(h) > 0.1 * std::max(V, scale); }

// The integral of asinh(. / scale) from V to V + h, to the rounding of itself.
double integral(double V, double h, double scale)
{
  if (isFar(V, h, scale)) {
    const auto m = [scale](double x) {
      return x * std::asinh(x / scale) - x * x / (std::hypot(x, scale) + scale);
    };
    return m(V + h) - m(V);
  }
  // Gauss's rule of five points, exact to rounding on so short an interval.
  const std::array<double, 3> at = {0, 0.5384693101056831, 0.9061798459386640};
  const std::array<double, 3> weight = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  double sum = weight[0] * std::asinh((V + h / 2) / scale);
  for (int i = 1; i < 3; ++i) {
    sum += weight[i] * (std::asinh((V + h / 2 * (1 - at[i])) / scale) +
                        std::asinh((V + h / 2 * (1 + at[i])) / scale));
  }
  return h / 2 * sum;
}
} // namespace

template <class Real>
Real Roughness::resistance(Real V) const
{
  return threshold + strength * std::asinh(V / scale);
}

template <class Real>
Real Roughness::minimiser(Real curvature, Real r) const
{
  Real left = 0;
  Real right = r > threshold ? (r - threshold) / curvature : 0;
  while (true) {
    const Real middle = (left + right) / 2;
    if (!(left < middle && middle < right)) {
      return right;
    }
    (curvature * middle + resistance(middle) < r ? left : right) = middle;
  }
}

template double Roughness::resistance(double) const;
template long double Roughness::resistance(long double) const;
template double Roughness::minimiser(double, double) const;
template long double Roughness::minimiser(long double, long double) const;

int RoughNodes::minimise(IndexView const& nodes, ConstNodeView const& curvature,
                         ConstBlockView const& r, BlockView const& v) const
{
  auto const which = toHost(nodes);
  auto const c = toHost(curvature);
  auto const forces = toHost(r);
  auto const result = toHost(v);
  for (std::size_t i = 0; i < which.extent(0); ++i) {
    const int node = which(i);
    auto const force = blockAt(forces, node);
    const double size = norm(force);
    const double speed = nodes_[node].minimiser(c(node), size);
    for (std::size_t k = 0; k < force.size(); ++k) {
      result(node, k) = speed > 0 ? speed * (force[k] / size) : 0;
    }
  }
  Kokkos::deep_copy(v, result);
  return 0;
}

int RoughNodes::sweep(IndexView const& nodes, DenseSystem const& system, BlockView const& v) const
{
  auto const which = toHost(nodes);
  auto const Z = toHost(system.Z);
  auto const r = toHost(system.r);
  auto const held = toHost(system.held);
  auto const c = toHost(system.curvature);
  auto const result = toHost(v);
  const std::size_t T = v.extent(1);
  for (std::size_t i = 0; i < which.extent(0); ++i) {
    const int node = which(i);
    Block force(T, 0);
    for (std::size_t k = 0; k < T; ++k) {
      force[k] = held(node * T + k) ? 0 : r(node, k) + c(node) * result(node, k);
    }
    const double size = norm(force);
    const double speed = nodes_[node].minimiser(c(node), size);
    for (std::size_t k = 0; k < T; ++k) {
      const double before = result(node, k);
      result(node, k) = speed > 0 ? speed * (force[k] / size) : 0;
      for (std::size_t row = 0; row < Z.extent(0); ++row) {
        r(row / T, row % T) -= Z(row, node * T + k) * (result(node, k) - before);
      }
    }
  }
  Kokkos::deep_copy(v, result);
  Kokkos::deep_copy(system.r, r);
  return 0;
}

void RoughNodes::linearise(ConstBlockView const& v, BlockView const& gradient,
                           HessianView const& hessian, FlagView const& kinked) const
{
  auto const at = toHost(v);
  auto const g = toHost(gradient);
  auto const H = toHost(hessian);
  auto const flag = toHost(kinked);
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    auto const& rough = nodes_[node];
    auto const block = blockAt(at, node);
    const double V = norm(block);
    const double second = rough.strength / std::hypot(V, rough.scale);
    flag(node) = V == 0 && rough.threshold > 0 ? 1 : 0;
    for (std::size_t k = 0; k < block.size(); ++k) {
      g(node, k) = V > 0 ? rough.resistance(V) * (block[k] / V) : 0;
      for (std::size_t l = 0; l < block.size(); ++l) {
        const double both = V > 0 ? (block[k] / V) * (block[l] / V) : 0;
        const double across = V > 0 ? rough.resistance(V) / V : second;
        H(node, k, l) = flag(node) ? 0 : second * both + across * ((k == l ? 1 : 0) - both);
      }
    }
  }
  Kokkos::deep_copy(gradient, g);
  Kokkos::deep_copy(hessian, H);
  Kokkos::deep_copy(kinked, flag);
}

double RoughNodes::slope(ConstBlockView const& v, ConstBlockView const& d, double t) const
{
  auto const start = toHost(v);
  auto const direction = toHost(d);
  double sum = 0;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    auto const step = blockAt(direction, node);
    auto const block = along(blockAt(start, node), t, step);
    const double V = norm(block);
    sum += V > 0 ? nodes_[node].resistance(V) * dot(block, step) / V
                 : nodes_[node].threshold * norm(step);
  }
  return sum;
}

EnergyChange RoughNodes::difference(ConstBlockView const& v, ConstBlockView const& d) const
{
  auto const start = toHost(v);
  auto const direction = toHost(d);
  EnergyChange result;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    auto const& rough = nodes_[node];
    auto const block = blockAt(start, node);
    auto const step = blockAt(direction, node);
    const double V = norm(block);
    const double sum = V + norm(along(block, 1, step));
    // |v + d| - |v|
    const double h = sum > 0 ? dot(along(step, 2, block), step) / sum : 0;
    result.change += rough.threshold * h + rough.strength * integral(V, h, rough.scale);
    result.magnitude += rough.resistance(sum) * (isFar(V, h, rough.scale) ? sum : std::abs(h));
  }
  return result;
}
} // namespace asperity::tnnmg::test
