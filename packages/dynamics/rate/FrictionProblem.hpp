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

  // The problem for the unknowns alone, where their held components rest but `prescribed`
  // (num_nodes, T) is added to what friction depends on.
  FrictionProblem withPrescribed(ConstBlockView const& prescribed) const
  {
    return {kernels_, {at_.alpha, at_.sigma_n, prescribed}};
  }

  int minimise(IndexView const& nodes, ConstNodeView const& curvature, ConstBlockView const& r,
               BlockView const& v) const override
  {
    return kernels_.minimise(nodes, curvature, r, at_, v);
  }
  int sweep(IndexView const& nodes, DenseSystem const& system, BlockView const& v) const override
  {
    return kernels_.sweep(nodes, system, at_, v);
  }
  void linearise(ConstBlockView const& v, BlockView const& gradient, HessianView const& hessian,
                 FlagView const& kinked) const override
  {
    kernels_.linearise(v, at_, gradient, hessian, kinked);
  }
  double slope(ConstBlockView const& v, ConstBlockView const& d, double t) const override
  {
    return kernels_.slope(v, d, t, at_);
  }
  tnnmg::EnergyChange difference(ConstBlockView const& v, ConstBlockView const& d) const override
  {
    auto const [change, magnitude] = kernels_.difference(v, d, at_);
    return {change, magnitude};
  }

private:
  friction::FrictionKernels const& kernels_;
  friction::StateAndStress at_;
};
} // namespace asperity::dynamics
