#pragma once

#include "friction/FrictionKernels.hpp"
#include "friction/detail/FrictionFunctors.hpp"
#include "friction/detail/Launch.hpp"

namespace asperity::friction::detail
{
// FrictionKernels for one law. The labels are made once: a launch must not allocate.
template <class Law>
class LawFrictionKernels : public FrictionKernels
{
public:
  explicit LawFrictionKernels(FaultData const& fault)
      : owned_(fault)
      , laws_(loadLaws<Law>(fault.parameters))
      , fault_(makeFaultNodes(laws_, owned_))
  {
  }

  int minimise(IndexView const& nodes, ConstNodeView const& curvature, ConstBlockView const& r,
               ConstNodeView const& alpha, BlockView const& v) const override
  {
    static const std::string label = "asperity::friction::minimise";
    return withComponents(v.extent(1), [&](auto T) {
      int num_failed = 0;
      Kokkos::parallel_reduce(label, range(static_cast<int>(nodes.extent(0))),
                              Minimise<Law, T>{fault_, nodes, curvature, r, alpha, v}, num_failed);
      return num_failed;
    });
  }

  void linearise(ConstBlockView const& v, ConstNodeView const& alpha, BlockView const& gradient,
                 HessianView const& hessian, FlagView const& kinked) const override
  {
    static const std::string label = "asperity::friction::linearise";
    withComponents(v.extent(1), [&](auto T) {
      Kokkos::parallel_for(label, range(fault_.size()),
                           Linearise<Law, T>{fault_, v, alpha, gradient, hessian, kinked});
    });
  }

  double slope(ConstBlockView const& v, ConstBlockView const& d, double t,
               ConstNodeView const& alpha) const override
  {
    static const std::string label = "asperity::friction::slope";
    return withComponents(v.extent(1), [&](auto T) {
      double sum = 0;
      Kokkos::parallel_reduce(label, range(fault_.size()), Slope<Law, T>{fault_, v, d, t, alpha},
                              sum);
      return sum;
    });
  }

  Difference difference(ConstBlockView const& v, ConstBlockView const& d,
                        ConstNodeView const& alpha) const override
  {
    static const std::string label = "asperity::friction::difference";
    return withComponents(v.extent(1), [&](auto T) {
      Difference sum{0, 0};
      Kokkos::parallel_reduce(label, range(fault_.size()), Differences<Law, T>{fault_, v, d, alpha},
                              sum.change, sum.magnitude);
      return sum;
    });
  }

  void coefficient(ConstBlockView const& v, ConstNodeView const& alpha,
                   NodeView const& mu) const override
  {
    static const std::string label = "asperity::friction::coefficient";
    withComponents(v.extent(1), [&](auto T) {
      Kokkos::parallel_for(label, range(fault_.size()), Coefficient<Law, T>{fault_, v, alpha, mu});
    });
  }

  int balance(ConstNodeView const& V, ConstNodeView const& mu, NodeView const& alpha) const override
  {
    static const std::string label = "asperity::friction::balance";
    int num_failed = 0;
    Kokkos::parallel_reduce(label, range(fault_.size()), Balance<Law>{fault_, V, mu, alpha},
                            num_failed);
    return num_failed;
  }

private:
  FaultData owned_; // keeps alive what fault_ points to
  LawView<Law> laws_;
  FaultNodes<Law> fault_;
};
} // namespace asperity::friction::detail
