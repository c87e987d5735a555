#pragma once

#include "fem/bulk/InelasticStrain.hpp"
#include "portability/Spaces.hpp"

#include <Kokkos_Core.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// What rock remembers in addition to its inelastic strain and the accumulated shear. A law that
// remembers more has a struct History, and a table that binds each variable to a member, a number
// or the components of a tensor in the order of tensorComponents():
//
//   struct History
//   {
//     double back_stress[most_tensor_components]; // Pa
//   };
//   static constexpr VariableOf<History> history[] = {
//     {&History::back_stress, {"back_stress", "Pa", "The centre of the elastic range."}}};
namespace asperity::fem
{
inline constexpr int most_tensor_components = 6;

// An internal variable for outputs; the name is unique among all laws of a run.
struct InternalVariable
{
  char const* name;
  char const* unit;
  char const* meaning; // a full sentence
};

// A variable in a cell's row of the history.
struct HistoryColumns
{
  InternalVariable variable;
  int first = 0, width = 0;
};

template <class History>
struct VariableOf
{
  using Tensor = double[most_tensor_components];

  constexpr VariableOf(double History::*member, InternalVariable info)
      : number(member)
      , variable(info)
  {
  }
  constexpr VariableOf(Tensor History::*member, InternalVariable info)
      : tensor(member)
      , variable(info)
  {
  }
  constexpr bool isTensor() const { return tensor != nullptr; }

  double History::*number = nullptr;
  Tensor History::*tensor = nullptr;
  InternalVariable variable;
};

template <class Law, class = void>
struct HasHistory : std::false_type
{
};
template <class Law>
struct HasHistory<Law, std::void_t<typename Law::History>> : std::true_type
{
};

namespace detail
{
// Calls visit(value in the history, column) for each number of one variable.
template <class Law, std::size_t row, class History, class Visit>
KOKKOS_INLINE_FUNCTION void visitVariable(History& history, int size, int& column,
                                          Visit const& visit)
{
  if constexpr (Law::history[row].isTensor()) {
    constexpr auto member = Law::history[row].tensor;
    for (int k = 0; k < size; ++k) {
      visit((history.*member)[k], column++);
    }
  } else {
    constexpr auto member = Law::history[row].number;
    visit(history.*member, column++);
  }
}

template <class Law, class History, class Visit, std::size_t... rows>
KOKKOS_INLINE_FUNCTION void visitHistory(History& history, int size, int column, Visit const& visit,
                                         std::index_sequence<rows...>)
{
  (visitVariable<Law, rows>(history, size, column, visit), ...);
}
} // namespace detail

// The history of a law in a row of `values`, from a column on. size: of a tensor.
template <class Law>
KOKKOS_INLINE_FUNCTION typename Law::History loadHistory(ConstTensorView const& values, int cell,
                                                         int column, int size)
{
  typename Law::History history{};
  detail::visitHistory<Law>(
    history, size, column, [&](double& value, int k) { value = values(cell, k); },
    std::make_index_sequence<std::size(Law::history)>());
  return history;
}

template <class Law>
KOKKOS_INLINE_FUNCTION void storeHistory(typename Law::History const& history,
                                         TensorView const& values, int cell, int column, int size)
{
  detail::visitHistory<Law>(
    history, size, column, [&](double const& value, int k) { values(cell, k) = value; },
    std::make_index_sequence<std::size(Law::history)>());
}

// The columns of a law's variables, the first one at 0. size: of a tensor.
template <class Law>
std::vector<HistoryColumns> historyColumns([[maybe_unused]] int size)
{
  std::vector<HistoryColumns> columns;
  if constexpr (HasHistory<Law>::value) {
    int first = 0;
    for (auto const& row : Law::history) {
      const int width = row.isTensor() ? size : 1;
      columns.push_back({row.variable, first, width});
      first += width;
    }
  }
  return columns;
}
} // namespace asperity::fem
