#pragma once

#include "registry/Registry.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"

#include <type_traits>
#include <utility>

namespace asperity::scenario
{
// A kind of condition on a boundary that is not a fault: a value of the entry `Type`. Its file, in
// `kinds` or in a library of your own, is all that it needs:
//
//   struct ElasticFoundation
//   {
//     static constexpr char const* meaning = "springs hold the boundary.";
//     static constexpr auto decides_on = DecidesOn::traction;
//     static void declare(Declare& declare);   // its entries; leave it out if there are none
//     template <int Dim>
//     static void add(BoundaryCondition const& condition, ConditionContext const& context,
//                     BoundaryConditions<Dim>& result);
//   };
//   ASPERITY_REGISTER(BoundaryKindRegistry, "Elastic Foundation",
//                     BoundaryKindOf<ElasticFoundation>)
//
// All types share one list of entries. So a name that another type has is refused, and entries are
// `optional`: a default would stand in the conditions of all other types, too.
//
// `add` reads the entries (ConditionEntries.hpp) and adds what the condition contributes: to
// result.velocities a condition on the velocity (fem::VelocityCondition), to result.tractions a
// load (fem::BoundaryTraction), to result.resistances dashpots or springs
// (fem::BoundaryResistance). InputError where the entries contradict each other.
//
// Optional are `static constexpr bool is_open = true`, where the body moves freely but for a load,
// and `reads_direction = true`, for the entry `Direction`, which several kinds share.
using BoundaryKindRegistry = Registry<ConditionType>;

namespace detail
{
template <class Type, class = void>
struct Declares : std::false_type
{
};
template <class Type>
struct Declares<Type, std::void_t<decltype(Type::declare(std::declval<Declare&>()))>>
    : std::true_type
{
};
template <class Type, class = void>
struct IsOpen : std::false_type
{
};
template <class Type>
struct IsOpen<Type, std::void_t<decltype(Type::is_open)>> : std::bool_constant<Type::is_open>
{
};
template <class Type, class = void>
struct ReadsDirection : std::false_type
{
};
template <class Type>
struct ReadsDirection<Type, std::void_t<decltype(Type::reads_direction)>>
    : std::bool_constant<Type::reads_direction>
{
};
} // namespace detail

// The type of condition that such a struct describes.
template <class Type>
struct BoundaryKindOf : ConditionType
{
  BoundaryKindOf()
  {
    meaning = Type::meaning;
    decides_on = Type::decides_on;
    is_open = detail::IsOpen<Type>::value;
    reads_direction = detail::ReadsDirection<Type>::value;
    if constexpr (detail::Declares<Type>::value) {
      declare = [](Declare& entries) { Type::declare(entries); };
    }
    const auto add = [](auto const& condition, auto const& context, auto& result) {
      Type::add(condition, context, result);
    };
    makers = {ConditionMaker<2>(add), ConditionMaker<3>(add)};
  }
};
} // namespace asperity::scenario
