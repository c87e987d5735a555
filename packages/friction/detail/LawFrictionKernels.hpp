#pragma once

#include "friction/FrictionKernels.hpp"
#include "friction/detail/Components.hpp"
#include "friction/detail/FrictionFunctors.hpp"

namespace asperity::friction::detail
{
// FrictionKernels for one law. The labels are made once: a launch must not allocate.
template <class Law>
class LawFrictionKernels : public FrictionKernels
{
public:
  explicit LawFrictionKernels(FaultView const& fault)
      : owned_(fault)
      , laws_(loadLaws<Law>(fault.parameters))
      , nodes_(makeNodePotentials(laws_, owned_))
  {
  }

  int minimise(IndexView const& nodes, ConstNodeView const& curvature, ConstBlockView const& r,
               StateAndStress const& at, BlockView const& v) const override
  {
    static const std::string label = "asperity::friction::minimise";
    return withComponents(v.extent(1), [&](auto T) {
      int num_failed = 0;
      Kokkos::parallel_reduce(label, RangePolicy(0, nodes.extent(0)),
                              Minimise<Law, T>{nodes_.at(at), nodes, curvature, r, v}, num_failed);
      return num_failed;
    });
  }

  int sweep(IndexView const& nodes, DenseSystem const& coupled, StateAndStress const& at,
            BlockView const& v) const override
  {
    return coupled.bounds.exist ? sweepWith<true>(v.extent(1) - 1, nodes, coupled, at, v)
                                : sweepWith<false>(v.extent(1), nodes, coupled, at, v);
  }

  void linearise(ConstBlockView const& v, StateAndStress const& at, BlockView const& gradient,
                 HessianView const& hessian, FlagView const& kinked) const override
  {
    static const std::string label = "asperity::friction::linearise";
    withComponents(v.extent(1), [&](auto T) {
      Kokkos::parallel_for(label, RangePolicy(0, nodes_.size()),
                           Linearise<Law, T>{nodes_.at(at), v, gradient, hessian, kinked});
    });
  }

  double slope(ConstBlockView const& v, ConstBlockView const& d, double t,
               StateAndStress const& at) const override
  {
    static const std::string label = "asperity::friction::slope";
    return withComponents(v.extent(1), [&](auto T) {
      double sum = 0;
      Kokkos::parallel_reduce(label, RangePolicy(0, nodes_.size()),
                              Slope<Law, T>{nodes_.at(at), v, d, t}, sum);
      return sum;
    });
  }

  Difference difference(ConstBlockView const& v, ConstBlockView const& d,
                        StateAndStress const& at) const override
  {
    static const std::string label = "asperity::friction::difference";
    return withComponents(v.extent(1), [&](auto T) {
      Difference sum{0, 0};
      Kokkos::parallel_reduce(label, RangePolicy(0, nodes_.size()),
                              Differences<Law, T>{nodes_.at(at), v, d}, sum.change, sum.magnitude);
      return sum;
    });
  }

  void coefficient(ConstBlockView const& v, ConstNodeView const& alpha,
                   NodeView const& mu) const override
  {
    static const std::string label = "asperity::friction::coefficient";
    withComponents(v.extent(1), [&](auto T) {
      Kokkos::parallel_for(label, RangePolicy(0, nodes_.size()),
                           Coefficient<Law, T>{nodes_, v, alpha, mu});
    });
  }

  int stateFor(ConstNodeView const& V, ConstNodeView const& mu,
               NodeView const& alpha) const override
  {
    static const std::string label = "asperity::friction::stateFor";
    int num_failed = 0;
    Kokkos::parallel_reduce(label, RangePolicy(0, nodes_.size()),
                            StateFor<Law>{nodes_, V, mu, alpha}, num_failed);
    return num_failed;
  }

private:
  template <bool Bounded>
  int sweepWith(std::size_t num_components, IndexView const& nodes, DenseSystem const& coupled,
                StateAndStress const& at, BlockView const& v) const
  {
    static const std::string label = "asperity::friction::sweep";
    return withComponents(num_components, [&](auto T) {
      int num_failed = 0;
      Kokkos::parallel_reduce(label, Kokkos::TeamPolicy<ExecutionSpace>(1, Kokkos::AUTO),
                              Sweep<Law, T, Bounded>{nodes_.at(at), nodes, coupled.Z, coupled.r,
                                                     coupled.held, coupled.curvature, v,
                                                     coupled.bounds.lower, coupled.bounds.upper},
                              num_failed);
      return num_failed;
    });
  }

  FaultView owned_; // keeps alive what nodes_ points to
  LawView<Law> laws_;
  NodePotentials<Law> nodes_;
};
} // namespace asperity::friction::detail
