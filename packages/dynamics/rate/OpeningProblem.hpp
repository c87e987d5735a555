#pragma once

#include "dynamics/rate/FrictionProblem.hpp"

namespace asperity::dynamics
{
// The nodal problem of a fault that may open. A block has the T tangential components, on which
// friction depends, and the velocity across, v_n, which has bounds: they say that the opening at
// the end of the step is not negative,
//   psi(v_t, v_n) = psi_friction(v_t), infinite where v_n is beyond its bounds.
// This is convex and separable, and so is the model that a sweep minimises at a node, since its
// curvature is a number: v_t is that of friction alone, and v_n is r_n / curvature, moved into the
// bounds. The stress of contact is the force that holds v_n at its bound.
class OpeningProblem final : public tnnmg::NodalProblem
{
public:
  // Memory for the tangential components, which several problems may use one after the other.
  struct Memory
  {
    Memory(int num_nodes, int num_tangents);
    BlockView v, other; // (num_nodes, T)
    HessianView hessian;
  };

  // bounds: of v_n(num_nodes). The memory must outlive this.
  OpeningProblem(FrictionProblem friction, Bounds bounds, Memory const& memory)
      : friction_(std::move(friction))
      , bounds_(std::move(bounds))
      , memory_(memory)
  {
  }

  Bounds bounds() const override { return bounds_; }
  int minimise(IndexView const& nodes, ConstNodeView const& curvature, ConstBlockView const& r,
               BlockView const& v) const override;
  int sweep(IndexView const& nodes, DenseSystem const& system, BlockView const& v) const override;
  void linearise(ConstBlockView const& v, BlockView const& gradient, HessianView const& hessian,
                 FlagView const& kinked) const override;
  double slope(ConstBlockView const& v, ConstBlockView const& d, double t) const override;
  tnnmg::EnergyChange difference(ConstBlockView const& v, ConstBlockView const& d) const override;

private:
  FrictionProblem friction_;
  Bounds bounds_;
  Memory const& memory_;
};

// Bounds of num_nodes components that are all zero: the fault stays shut.
Bounds shut(int num_nodes);
} // namespace asperity::dynamics
