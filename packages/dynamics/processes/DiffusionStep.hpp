#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"

#include <array>
#include <memory>
#include <vector>

namespace asperity::dynamics
{
// Steps of S p_t + K p = q in time, with a lumped S > 0 and the stiffness K of a diffusion, at the
// nodes of a fault; p keeps its value at nodes where it is fixed. By the two stages of Alexander
// (1977) with gamma = 1 - 1/sqrt(2): of second order, L-stable, and without fixed nodes
// sum(S (p1 - p0)) is what q brings in. The two stages share one matrix, S + gamma tau K, which
// conjugate gradients solve to a relative residual of 1e-12. They are preconditioned by the
// factors of each rank's block, which on one rank solve it at once.
class DiffusionStep
{
public:
  // S(num_nodes) of the rows of K; is_fixed(num_nodes).
  DiffusionStep(RCP<const CrsMatrix> const& K, std::vector<double> const& S,
                std::vector<bool> const& is_fixed);
  ~DiffusionStep();

  // q(num_nodes) at two times in the step, which is taken as linear in time: the points of Gauss,
  // so that the sum of a q that jumps at the ends of steps is exact.
  static constexpr int num_times = 2;
  static double timeIn(int k); // as a share of the step, 0 < timeIn(0) < timeIn(1) < 1
  using Sources = std::array<std::vector<double>, num_times>;

  // p1(num_nodes) at the end of a step of tau [s] from p0(num_nodes), in a unit of its own; q has
  // that of S times that of p / s. Throws SolveError if p is not finite or the matrix too badly
  // conditioned. Collective.
  void advance(double tau, ConstNodeView const& p0, Sources const& q, NodeView const& p1);

private:
  struct System;
  System& systemOf(double gamma_tau);
  void rateOfStage(System& system, Vector const& p, Vector& rate);

  RCP<const CrsMatrix> K_;
  std::vector<double> S_;
  std::vector<bool> is_fixed_;
  std::vector<std::unique_ptr<System>> systems_; // the last ones used, the latest first
  RCP<Vector> p_, q_, first_, second_, right_side_;
};
} // namespace asperity::dynamics
