#pragma once

#include "portability/Registry.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

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
// `add` reads the entries (ConditionEntries.hpp) and adds what the condition contributes: to
// result.velocities a condition on the velocity (fem::VelocityCondition), to result.tractions a
// load (fem::BoundaryTraction), to result.resistances dashpots or springs
// (fem::BoundaryResistance). InputError where the entries contradict each other.
class BoundaryKind
{
public:
  static constexpr char const* registered_as = "boundary condition";
  BoundaryKind() = default;
  virtual ~BoundaryKind() = default;
  BoundaryKind(BoundaryKind const&) = delete;
  BoundaryKind& operator=(BoundaryKind const&) = delete;

  virtual std::string meaning() const = 0; // a sentence for the list of parameters
  virtual DecidesOn decidesOn() const = 0;
  // Whether the body moves freely there, but for a load: `static constexpr bool is_open = true`.
  virtual bool isOpen() const = 0;
  // Whether it reads the entry `Direction`, which several kinds share: `reads_direction`.
  virtual bool readsDirection() const = 0;
  virtual void declare(Declare& declare) const = 0;
  virtual void add(BoundaryCondition const& condition, ConditionContext const& context,
                   BoundaryConditions<2>& result) const = 0;
  virtual void add(BoundaryCondition const& condition, ConditionContext const& context,
                   BoundaryConditions<3>& result) const = 0;

  std::vector<std::string> entries() const; // that it reads, without `Boundary` and `Type`
};

using BoundaryKindRegistry = Registry<BoundaryKind>;

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

template <class Type>
class BoundaryKindOf final : public BoundaryKind
{
public:
  std::string meaning() const override { return Type::meaning; }
  DecidesOn decidesOn() const override { return Type::decides_on; }
  bool isOpen() const override { return detail::IsOpen<Type>::value; }
  bool readsDirection() const override { return detail::ReadsDirection<Type>::value; }
  void declare([[maybe_unused]] Declare& declare) const override
  {
    if constexpr (detail::Declares<Type>::value) {
      Type::declare(declare);
    }
  }
  void add(BoundaryCondition const& condition, ConditionContext const& context,
           BoundaryConditions<2>& result) const override
  {
    Type::add(condition, context, result);
  }
  void add(BoundaryCondition const& condition, ConditionContext const& context,
           BoundaryConditions<3>& result) const override
  {
    Type::add(condition, context, result);
  }
};
} // namespace asperity::scenario
