#pragma once

#include "friction/Length.hpp"
#include "friction/detail/NodePotentials.hpp"

// There is one functor for each kernel of FrictionKernels, whose comments say what they compute. v,
// r, d and gradient have the shape (num_nodes, T), the others (num_nodes). Their views do not count
// references, which would take longer than the work at one node.
namespace asperity::friction::detail
{
// v_i := the minimiser under the force r_i, which is at right angles to the prescribed velocity of
// the given length. Returns whether there is a minimiser; v does not change if there is none.
template <int T, class Potential>
KOKKOS_INLINE_FUNCTION bool minimiseAt(Potential const& potential, double prescribed_rate,
                                       double curvature, double const (&force)[T], double* v)
{
  double rate[T];
  for (int j = 0; j < T; ++j) {
    rate[j] = v[j];
  }
  const double load = length(force);
  const auto solution =
    prescribed_rate > 0
      ? potential.minimiseWithPrescribed(prescribed_rate, curvature, load, length(rate))
      : potential.minimise(curvature, load, length(rate));
  for (int j = 0; j < T && solution.converged; ++j) {
    v[j] = solution.V == 0 ? 0 : solution.V * (force[j] / load);
  }
  return solution.converged;
}

template <class Law, int T>
struct Minimise
{
  NodePotentials<Law> potentials;
  Unmanaged<IndexView> nodes;
  Unmanaged<ConstNodeView> curvature;
  Unmanaged<ConstBlockView> r;
  Unmanaged<BlockView> v;

  KOKKOS_INLINE_FUNCTION void operator()(int k, int& num_failed) const
  {
    const int node = nodes(k);
    double force[T];
    for (int j = 0; j < T; ++j) {
      force[j] = r(node, j);
    }
    num_failed += minimiseAt(potentials(node), potentials.template prescribedRate<T>(node),
                             curvature(node), force, &v(node, 0))
                    ? 0
                    : 1;
  }
};

// One team goes from node to node. All of its threads minimise at the node, with the same result,
// and each subtracts its part of Z times the change, for which rows of Z serve as columns. If
// Bounded, blocks of Z, r and v have one more component, on which friction does not depend: its
// minimiser is that of the quadratic part, moved into the bounds.
template <class Law, int T, bool Bounded>
struct Sweep
{
  using Team = Kokkos::TeamPolicy<ExecutionSpace>::member_type;
  static constexpr int size = Bounded ? T + 1 : T;

  NodePotentials<Law> potentials;
  Unmanaged<IndexView> nodes;
  Unmanaged<ConstBlockView> Z;
  Unmanaged<BlockView> r;
  Unmanaged<IndexView> held;
  Unmanaged<ConstNodeView> curvature;
  Unmanaged<BlockView> v;
  Unmanaged<ConstNodeView> lower, upper; // of the last component, if it has bounds

  KOKKOS_INLINE_FUNCTION void operator()(Team const& team, int& num_failed) const
  {
    for (int k = 0; k < static_cast<int>(nodes.extent(0)); ++k) {
      const int node = nodes(k);
      double force[T], after[size], change[size];
      for (int j = 0; j < T; ++j) {
        after[j] = v(node, j);
        force[j] = held(node * size + j) ? 0 : r(node, j) + curvature(node) * after[j];
      }
      const bool found = minimiseAt(potentials(node), potentials.template prescribedRate<T>(node),
                                    curvature(node), force, after);
      if constexpr (Bounded) {
        after[T] = v(node, T);
        if (found && !held(node * size + T)) {
          after[T] = within(lower(node), after[T] + r(node, T) / curvature(node), upper(node));
        }
      }
      bool changed = false;
      for (int j = 0; j < size; ++j) {
        change[j] = after[j] - v(node, j);
        changed = changed || change[j] != 0;
      }
      team.team_barrier(); // all have read v and r
      Kokkos::single(Kokkos::PerTeam(team), [&]() {
        num_failed += found ? 0 : 1;
        for (int j = 0; j < size; ++j) {
          v(node, j) = after[j];
        }
      });
      if (changed) {
        subtractColumns(team, node * size, change);
      }
      team.team_barrier();
    }
  }

private:
  KOKKOS_INLINE_FUNCTION void subtractColumns(Team const& team, int first,
                                              double const (&change)[size]) const
  {
    const int columns = static_cast<int>(Z.extent(1));
    double const* const z = &Z(first, 0);
    double* const force = r.data();
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, columns), [&](int i) {
      double sum = 0;
      for (int j = 0; j < size; ++j) {
        sum += z[j * columns + i] * change[j];
      }
      force[i] -= sum;
    });
  }
};

template <class Law, int T>
struct Linearise
{
  NodePotentials<Law> potentials;
  Unmanaged<ConstBlockView> v;
  Unmanaged<BlockView> gradient;
  Unmanaged<HessianView> hessian;
  Unmanaged<FlagView> kinked;

  KOKKOS_INLINE_FUNCTION void operator()(int node) const
  {
    double unit[T] = {};
    potentials.loadRate(node, &v(node, 0), unit);
    const double s = length(unit);
    for (int j = 0; j < T && s > 0; ++j) {
      unit[j] /= s;
    }
    const auto potential = potentials(node);
    const double force = s > 0 ? potential.derivative(s) : 0;
    const double radial = potential.secondDerivative(s);
    const double transverse = s > 0 ? force / s : radial;
    const bool smooth =
      isFinite(radial) && (T == 1 || isFinite(transverse)) && !potential.kinkedAt(s);
    kinked(node) = !smooth;
    for (int j = 0; j < T; ++j) {
      gradient(node, j) = force * unit[j];
      for (int k = 0; k < T; ++k) {
        const double along = s > 0 ? unit[j] * unit[k] : (j == k);
        const double across = T == 1 ? 0 : (j == k) - along;
        hessian(node, j, k) = smooth ? radial * along + (T == 1 ? 0 : transverse * across) : 0;
      }
    }
  }
};

template <class Law, int T>
struct Slope
{
  NodePotentials<Law> potentials;
  Unmanaged<ConstBlockView> v;
  Unmanaged<ConstBlockView> d;
  double t;

  KOKKOS_INLINE_FUNCTION void operator()(int node, double& sum) const
  {
    double direction[T], rate[T];
    potentials.loadRate(node, &v(node, 0), rate);
    for (int j = 0; j < T; ++j) {
      direction[j] = d(node, j);
      rate[j] += t * direction[j];
    }
    const double s = length(rate);
    double growth = 0; // of |v + t d| with t, from above
    for (int j = 0; j < T && s > 0; ++j) {
      growth += rate[j] / s * direction[j];
    }
    if (s == 0) {
      growth = length(direction);
    }
    sum += potentials(node).derivative(s) * growth;
  }
};

// |v + d| - |v| = <d, 2 v + d> / (|v| + |v + d|) keeps its digits however small d is.
template <class Law, int T>
struct Differences
{
  NodePotentials<Law> potentials;
  Unmanaged<ConstBlockView> v;
  Unmanaged<ConstBlockView> d;

  KOKKOS_INLINE_FUNCTION void operator()(int node, double& change, double& magnitude) const
  {
    double before[T], after[T];
    potentials.loadRate(node, &v(node, 0), before);
    for (int j = 0; j < T; ++j) {
      after[j] = before[j] + d(node, j);
    }
    const double s = length(before);
    const double s_after = length(after);
    const double sum = s + s_after;
    if (sum == 0) {
      return;
    }
    double growth = 0, terms = 0;
    for (int j = 0; j < T; ++j) {
      const double term = (2 * before[j] + d(node, j)) / sum * d(node, j);
      growth += term;
      terms += math::fabs(term);
    }
    const auto potential = potentials(node);
    change += potential.meanDerivative(s, growth) * growth;
    magnitude += potential.termsOfDerivative(larger(s, s_after)) * terms;
  }
};

template <class Law, int T>
struct Coefficient
{
  NodePotentials<Law> nodes;
  Unmanaged<ConstBlockView> v;
  Unmanaged<ConstNodeView> alpha;
  Unmanaged<NodeView> mu;

  KOKKOS_INLINE_FUNCTION void operator()(int node) const
  {
    double rate[T];
    for (int j = 0; j < T; ++j) {
      rate[j] = v(node, j);
    }
    const auto curve = nodes.laws(node).at(alpha(node));
    mu(node) = curve.mu(nodes.slip_factor(node) * length(rate));
  }
};

template <class Law>
struct StateFor
{
  NodePotentials<Law> nodes;
  Unmanaged<ConstNodeView> V;
  Unmanaged<ConstNodeView> mu;
  Unmanaged<NodeView> alpha;

  KOKKOS_INLINE_FUNCTION void operator()(int node, int& num_failed) const
  {
    const bool slides = V(node) > 0 && mu(node) > 0;
    const double state = slides ? nodes.laws(node).stateFor(V(node), mu(node)) : 0;
    if (!slides || !isFinite(state)) {
      ++num_failed;
      return;
    }
    alpha(node) = state;
  }
};
} // namespace asperity::friction::detail
