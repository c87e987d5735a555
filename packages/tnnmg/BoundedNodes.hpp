#pragma once

#include "tnnmg/TnnmgVectors.hpp"

#include <Tpetra_Vector.hpp>

// The arithmetic of TNNMG at nodes whose last component has bounds. A component is fixed if it is
// held, at a bound, or where psi has no useful second derivative: the correction is zero there,
// while the other components of the node take part.
namespace asperity::tnnmg::detail
{
class BoundedNodes
{
public:
  // bounds: of the last components (num_nodes).
  BoundedNodes(NonlinearNodes const& nodes, Bounds const& bounds);

  // Moves the last component of v(num_nodes, T) into its bounds, and onto a bound from which it
  // differs by rounding alone; sets x, on Z's rows, there.
  void moveIntoBounds(BlockView const& v, Vector& x) const;
  // As TnnmgBlocks::truncate, by components: sets the Hessian of fixed components to
  // stiff * curvature, so that the linear correction nearly leaves them out, and truncates the
  // nodes of which all are fixed.
  void truncate(TnnmgBlocks const& blocks, ConstNodeView const& curvature, double stiff) const;
  // x = 0 at fixed components.
  void clearFixed(Vector& x) const;
  // Shortens c in the last components such that v + c, v(num_nodes, T), is within the bounds.
  void project(ConstBlockView const& v, Vector& c) const;
  // The largest step <= 1 for which v + step c is within the bounds at this rank's nodes.
  double largestStep(ConstBlockView const& v, Vector const& c) const;

private:
  NonlinearNodes nodes_;
  Bounds bounds_;
  Kokkos::View<int**, Kokkos::LayoutRight, MemorySpace> fixed_; // (num_nodes, T)
};
} // namespace asperity::tnnmg::detail
