#pragma once

#include "friction/StateKernels.hpp"
#include "friction/Table.hpp"
#include "friction/detail/BackwardEuler.hpp"
#include "friction/detail/NodePotentials.hpp"

#include <string>
#include <type_traits>
#include <utility>

namespace asperity::friction::detail
{
template <class Law, class = void>
struct HasFlow : std::false_type
{
};

template <class Law>
struct HasFlow<Law, std::void_t<decltype(std::declval<Law const&>().flow(0.0, 0.0, 0.0))>>
    : std::true_type
{
};

template <class Law, class = void>
struct HasTable : std::false_type
{
};

template <class Law>
struct HasTable<Law, std::void_t<decltype(std::declval<Law const&>().table)>> : std::true_type
{
};

// The laws with the table, if they have one.
template <class Law>
LawView<Law> withTable(LawView<Law> const& laws, [[maybe_unused]] TableView const& table)
{
  if constexpr (HasTable<Law>::value) {
    const Kokkos::View<Law*, MemorySpace> result(
      Kokkos::view_alloc("asperity::friction::laws", Kokkos::WithoutInitializing), laws.extent(0));
    const Table of_law{table.data(), table.extent_int(0)};
    Kokkos::parallel_for(
      "asperity::friction::withTable", RangePolicy(0, laws.extent(0)), KOKKOS_LAMBDA(int node) {
        result(node) = laws(node);
        result(node).table = of_law;
      });
    ExecutionSpace().fence();
    return result;
  } else {
    return laws;
  }
}

template <class Law>
struct StateFlow
{
  Unmanaged<LawView<Law>> laws;
  Unmanaged<ConstNodeView> V;
  double dt;
  Unmanaged<ConstNodeView> alpha0;
  Unmanaged<NodeView> alpha1;

  KOKKOS_INLINE_FUNCTION void operator()(int node, int& num_failed) const
  {
    if constexpr (HasFlow<Law>::value) {
      alpha1(node) = laws(node).flow(V(node), dt, alpha0(node));
    } else {
      const double alpha = alpha0(node);
      const auto solution = BackwardEuler<Law>(laws(node), V(node), dt, alpha).solve();
      alpha1(node) = solution.alpha;
      num_failed += !solution.converged;
    }
  }
};

template <class Law>
struct SteadyState
{
  Unmanaged<LawView<Law>> laws;
  Unmanaged<ConstNodeView> V;
  Unmanaged<NodeView> alpha;

  KOKKOS_INLINE_FUNCTION void operator()(int node) const
  {
    alpha(node) = laws(node).steadyState(V(node));
  }
};

// StateKernels for one law. The labels are made once: a launch must not allocate.
template <class Law>
class LawStateKernels : public StateKernels
{
public:
  explicit LawStateKernels(ParameterView const& parameters, TableView const& table = {})
      : table_(table)
      , laws_(withTable<Law>(loadLaws<Law>(parameters), table))
  {
  }

  int flow(ConstNodeView const& V, double dt, ConstNodeView const& alpha0,
           NodeView const& alpha1) const override
  {
    static const std::string label = "asperity::friction::flow";
    int num_failed = 0;
    Kokkos::parallel_reduce(label, RangePolicy(0, laws_.extent(0)),
                            StateFlow<Law>{laws_, V, dt, alpha0, alpha1}, num_failed);
    return num_failed;
  }

  void steadyState(ConstNodeView const& V, NodeView const& alpha) const override
  {
    static const std::string label = "asperity::friction::steadyState";
    Kokkos::parallel_for(label, RangePolicy(0, laws_.extent(0)), SteadyState<Law>{laws_, V, alpha});
  }

private:
  TableView table_; // to which the laws point
  LawView<Law> laws_;
};
} // namespace asperity::friction::detail
