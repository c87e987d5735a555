#pragma once

#include "base/parallel/Reductions.hpp"
#include "tnnmg/FaultColumns.hpp"
#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <array>

// The vectors of a TNNMG iteration, and the arithmetic on them that does not involve psi.
namespace asperity::tnnmg::detail
{
// A change of J, and the sum of the magnitudes of the terms that add up to it.
struct EnergyChange
{
  double change = 0;
  double magnitude = 0;
  // Whether J is larger by more than rounding explains.
  int rises() const { return change > 10 * 2.220446049250313e-16 * magnitude ? 1 : 0; }
};

// Values at the nonlinear nodes.
struct TnnmgBlocks
{
  explicit TnnmgBlocks(NonlinearNodes const& nodes);

  void differenceTo(BlockView const& reference,
                    BlockView const& result) const; // result = v - reference
  // Truncates, besides the nodes at a kink, those that are held in all components and those whose
  // Hessian exceeds stiff * curvature. Sets the held components of all Hessians to zero.
  void truncate(NonlinearNodes const& nodes, ConstNodeView const& curvature, double stiff) const;

  BlockView v, before, d, scaled, residual, gradient;
  HessianView hessian;
  FlagView truncated;
};

struct TnnmgVectors
{
  // `linear` multiplies by Z, and must outlive this.
  TnnmgVectors(CrsMatrix const& Z, NonlinearNodes const& nodes, LinearCorrection const& linear);

  void start(CrsMatrix const& Z, Vector const& b, Vector const& guess);
  void beginIteration();
  // Updates the residual r after the sweeps have changed v by blocks.d, unless the sweeps do so
  // themselves. Returns 1 if J rose, else 0. nonlinear_change and magnitude: this rank's part of
  // the change of psi. Collective.
  int finishSweeps(CrsMatrix const& Z, NonlinearNodes const& nodes, TnnmgBlocks const& blocks,
                   Vector const& b, double nonlinear_change, double magnitude);
  // newton_residual = b - Z v - gradient, zero in the held components of nonlinear nodes
  void newtonResidual(NonlinearNodes const& nodes, ConstBlockView const& gradient);

  struct Along
  {
    double start;     // <Z v - b, c>
    double curvature; // <Z c, c>
  };
  // This rank's parts of what a line search needs to know of the correction; keep() takes the sums
  // over the ranks. One product with Z.
  std::array<double, 3> derivativeAlongCorrection(CrsMatrix const& Z);
  Along keep(double const* sums);

  // This rank's part of J(v + step c) - J(v) from psi; blocks.d holds c at the nonlinear nodes.
  template <class NodalProblem>
  EnergyChange nonlinearChange(NodalProblem const& problem, TnnmgBlocks const& blocks,
                               double step) const;
  // J(v + step c) - J(v), from the sum of that over the ranks.
  EnergyChange changeAlong(double step, EnergyChange const& nonlinear) const;
  void move(double step); // v += step c, and the ghosts of v that the nonlinear nodes need

  struct Norms
  {
    double change = 0, v = 0; // of v - v_before and of v in the norm of Z
    int failed_nodes = 0;     // on any rank
  };
  // Collective.
  Norms norms(Vector const& b, int failed_nodes) const;

  FaultColumns exchange;

  RCP<Vector> v_columns, v; // v is the owned part of v_columns
  RCP<Vector> v_before, r, r_before, newton_residual, c, Zc, b_copy;

private:
  void residual(CrsMatrix const& Z, Vector const& b); // r = b - Z v

  RCP<Vector> diagonal_; // of Z
  LinearCorrection const& linear_;
  Along along_{};
  double magnitude_ = 0;   // of the terms of the derivative along the correction
  bool few_nodes_ = false; // the nonlinear nodes have few of the dofs of all ranks
  RCP<Vector> columns_;    // work space
};

template <class NodalProblem>
EnergyChange TnnmgVectors::nonlinearChange(NodalProblem const& problem, TnnmgBlocks const& blocks,
                                           double step) const
{
  auto const scaled = blocks.scaled;
  auto const d = blocks.d;
  const int size = static_cast<int>(d.extent(1));
  Kokkos::parallel_for(
    "asperity::tnnmg::scale", Kokkos::RangePolicy<ExecutionSpace>(0, d.extent(0)),
    KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        scaled(node, k) = step * d(node, k);
      }
    });
  auto const nonlinear = problem.difference(blocks.v, scaled);
  return {nonlinear.change, nonlinear.magnitude};
}
} // namespace asperity::tnnmg::detail
