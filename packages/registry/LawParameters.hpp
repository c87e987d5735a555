#pragma once

#include "portability/Spaces.hpp"
#include "registry/Parameter.hpp"

#include <Kokkos_Core.hpp>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <type_traits>
#include <utility>

// A law of friction, state or rock is a struct that holds the values of its parameters at one node
// or in one cell. A table binds each parameter to the member that holds its value:
//
//   struct Maxwell
//   {
//     static constexpr char const* name = "Maxwell";
//     double viscosity; // Pa s
//     static constexpr ParameterOf<Maxwell> parameters[] = {
//       {&Maxwell::viscosity, {"Viscosity", "Pa s", no_default, Range::positive(), "."}}};
//   };
//
// The functions here are all that knows the order of the table. A law without parameters has no
// table. The struct is trivially copyable, so that kernels can take it. Members of its first base
// count as its own; members of further bases do not, since g++ 12 takes their pointers for others
// where the struct is not complete.
namespace asperity
{
template <class Law>
struct ParameterOf
{
  double Law::*member;
  Parameter parameter;
};

namespace detail
{
template <class Law, class = void>
struct NumParameters : std::integral_constant<std::size_t, 0>
{
};
template <class Law>
struct NumParameters<Law, std::void_t<decltype(Law::parameters)>>
    : std::integral_constant<std::size_t, std::size(Law::parameters)>
{
};

template <std::size_t row, class Law>
KOKKOS_INLINE_FUNCTION double& valueOf(Law& law)
{
  constexpr auto member = Law::parameters[row].member;
  return law.*member;
}

template <class Law, class Values, std::size_t... rows>
KOKKOS_INLINE_FUNCTION Law loadLaw([[maybe_unused]] Values const& values,
                                   std::index_sequence<rows...>)
{
  Law law{};
  ((valueOf<rows>(law) = values(rows)), ...);
  return law;
}

template <class Law, class = void>
struct Prepares : std::false_type
{
};
template <class Law>
struct Prepares<Law, std::void_t<decltype(std::declval<Law&>().prepare())>> : std::true_type
{
};
} // namespace detail

template <class Law>
inline constexpr std::size_t num_parameters = detail::NumParameters<Law>::value;

// The law whose parameters are values(row), rows in the order of the table. A law that has a member
// function prepare() derives there what else it needs, as the sine of an angle.
template <class Law, class Values, class = std::enable_if_t<!std::is_pointer_v<Values>>>
KOKKOS_INLINE_FUNCTION Law loadLaw(Values const& values)
{
  auto law = detail::loadLaw<Law>(values, std::make_index_sequence<num_parameters<Law>>());
  if constexpr (detail::Prepares<Law>::value) {
    law.prepare();
  }
  return law;
}

// The same from an array on the host.
template <class Law>
Law loadLaw(double const* values)
{
  return loadLaw<Law>([values](std::size_t row) { return values[row]; });
}

// Whether each parameter has a member of its own.
template <class Law>
bool bindsDistinctMembers()
{
  if constexpr (detail::NumParameters<Law>::value > 0) {
    Law law{};
    double value = 0;
    for (auto const& row : Law::parameters) {
      law.*row.member = ++value;
    }
    value = 0;
    for (auto const& row : Law::parameters) {
      if (law.*row.member != ++value) {
        return false;
      }
    }
  }
  return true;
}

// The parameters in the order of the table, appended to a container. Ends the program if two have
// one member: this is called where libraries are loaded, and nothing may be thrown.
template <class Law, class Container>
void appendParameters([[maybe_unused]] Container& parameters)
{
  if (!bindsDistinctMembers<Law>()) {
    std::fprintf(stderr,
                 "asperity: the table of the law '%s' binds two parameters to one member. Bind "
                 "members of the law itself or of its first base.\n",
                 Law::name);
    std::abort();
  }
  if constexpr (detail::NumParameters<Law>::value > 0) {
    for (auto const& row : Law::parameters) {
      parameters.push_back(row.parameter);
    }
  }
}
} // namespace asperity
