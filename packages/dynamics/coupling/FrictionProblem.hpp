#pragma once

#include "friction/FrictionKernels.hpp"
#include "tnnmg/NodalProblem.hpp"

#include <utility>

namespace asperity::dynamics
{
// Friction at given states and normal stresses, as the nodal problem of TNNMG.
class FrictionProblem : public tnnmg::NodalProblem
{
public:
  FrictionProblem(friction::FrictionKernels const& kernels, friction::StateAndStress at)
      : kernels_(kernels)
      , at_(std::move(at))
  {
  }

  int minimise(friction::IndexView const& nodes, friction::ConstNodeView const& curvature,
               friction::ConstBlockView const& r, friction::BlockView const& v) const override
  {
    return kernels_.minimise(nodes, curvature, r, at_, v);
  }
  int sweep(friction::IndexView const& nodes, tnnmg::CoupledSystem const& system,
            friction::BlockView const& v) const override
  {
    return kernels_.sweep(nodes, {system.Z, system.r, system.held, system.curvature}, at_, v);
  }
  void linearise(friction::ConstBlockView const& v, friction::BlockView const& gradient,
                 friction::HessianView const& hessian,
                 friction::FlagView const& kinked) const override
  {
    kernels_.linearise(v, at_, gradient, hessian, kinked);
  }
  double slope(friction::ConstBlockView const& v, friction::ConstBlockView const& d,
               double t) const override
  {
    return kernels_.slope(v, d, t, at_);
  }
  tnnmg::EnergyChange difference(friction::ConstBlockView const& v,
                                 friction::ConstBlockView const& d) const override
  {
    auto const [change, magnitude] = kernels_.difference(v, d, at_);
    return {change, magnitude};
  }

private:
  friction::FrictionKernels const& kernels_;
  friction::StateAndStress at_;
};
} // namespace asperity::dynamics
