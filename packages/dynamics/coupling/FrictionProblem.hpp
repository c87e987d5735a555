#pragma once

#include "friction/FrictionKernels.hpp"
#include "tnnmg/NonlinearNodes.hpp"

namespace asperity::dynamics
{
// Friction at given states and normal stresses, as the nodal problem of TNNMG.
struct FrictionProblem
{
  friction::FrictionKernels const& kernels;
  friction::StateAndStress at;

  int minimise(friction::IndexView const& nodes, friction::ConstNodeView const& curvature,
               friction::ConstBlockView const& r, friction::BlockView const& v) const
  {
    return kernels.minimise(nodes, curvature, r, at, v);
  }
  int sweep(friction::IndexView const& nodes, tnnmg::CoupledSystem const& system,
            friction::BlockView const& v) const
  {
    return kernels.sweep(nodes, {system.Z, system.r, system.held, system.curvature}, at, v);
  }
  void linearise(friction::ConstBlockView const& v, friction::BlockView const& gradient,
                 friction::HessianView const& hessian, friction::FlagView const& kinked) const
  {
    kernels.linearise(v, at, gradient, hessian, kinked);
  }
  double slope(friction::ConstBlockView const& v, friction::ConstBlockView const& d, double t) const
  {
    return kernels.slope(v, d, t, at);
  }
  friction::FrictionKernels::Difference difference(friction::ConstBlockView const& v,
                                                   friction::ConstBlockView const& d) const
  {
    return kernels.difference(v, d, at);
  }
};
} // namespace asperity::dynamics
