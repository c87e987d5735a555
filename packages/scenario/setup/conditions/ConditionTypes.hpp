#pragma once

#include "scenario/setup/conditions/BoundarySetup.hpp"

#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace asperity::scenario
{
struct BoundaryCondition;

// Names of entries of a condition that its declaration and its readers share.
namespace condition_entries
{
inline constexpr char const* type = "Type";
inline constexpr char const* direction = "Direction";
inline constexpr char const* plate_rate = "Plate Rate";
inline constexpr char const* slip_rate = "Slip Rate";
inline constexpr char const* contact = "Contact";
inline constexpr char const* velocity = "Velocity"; // of the Type Prescribed Velocity
} // namespace condition_entries

// What all conditions of a deck share.
struct ConditionContext
{
  int components;              // of the displacement
  fem::Boundaries along_fault; // the fault and its continuations
};

enum class ConditionPlace
{
  fault,
  continuation, // of the fault
  elsewhere
};

// What a condition decides on. It limits the other conditions on the same boundary: two may each
// prescribe a direction, but only one the traction, and a condition that holds the boundary or
// leaves it free allows no other.
enum class DecidesOn
{
  direction,
  traction,
  rest,
  freedom // no traction
};

// Adds a condition of the deck to the result.
template <int Dim>
using ConditionMaker =
  std::function<void(BoundaryCondition const&, ConditionContext const&, BoundaryConditions<Dim>&)>;

// A value of the entry `Type` of a boundary condition. A kind of fault (FaultKind.hpp) becomes one,
// and so does a struct that describes a condition on another boundary (BoundaryKindOf).
struct ConditionType
{
  static constexpr char const* registered_as = "boundary condition";

  std::string name;
  std::string meaning; // a sentence for the list of parameters
  ConditionPlace place = ConditionPlace::elsewhere;
  DecidesOn decides_on = DecidesOn::traction;
  bool is_open = false;                  // the body moves freely there, but for a load
  bool reads_direction = false;          // the entry `Direction`, which several types share
  std::function<void(Declare&)> declare; // its own entries; empty if it has none
  std::tuple<ConditionMaker<2>, ConditionMaker<3>> makers;
  fem::OtherSide other_side = {}; // of a fault
  std::vector<std::string> reads; // entries other than `Boundary` and `Type`

  bool isFault() const { return place == ConditionPlace::fault; }
  bool isContinuation() const { return place == ConditionPlace::continuation; }
  bool readsEntry(std::string const& entry) const;
};

// All types that a deck may choose from, each once: the registered kinds of fault (FaultKind.hpp),
// their continuation, and the registered conditions on other boundaries (BoundaryKind.hpp).
std::vector<ConditionType> const& conditionTypes();
ConditionType const& conditionType(std::string const& name);
// The one that continues a fault at a given slip rate.
ConditionType const& continuationType();

// One completed sublist of the deck's list `Boundary Conditions`.
struct BoundaryCondition
{
  BoundaryCondition(std::string const& path, ParameterList const& completed);

  std::string name; // its path, for messages
  ParameterList list;
  ConditionType const* type;
  std::string boundary;
  std::optional<std::vector<double>> direction; // as the deck gives it
  bool may_open = false;                        // whether `Contact` is Unilateral

  bool liesAlongFault() const { return type->place != ConditionPlace::elsewhere; }
  bool givesSlipRate() const { return isGiven(list, condition_entries::slip_rate); }
  bool isFaultInside() const { return type->isFault() && type->other_side.is_inside; }
};

// The deck's list `Boundary Conditions`: one sublist, of any name, for each condition. InputError
// if two types declare an entry of one name.
RCP<const ParameterList> boundaryParameters();

// The boundary conditions of the completed list, in the order of the deck.
std::vector<BoundaryCondition> readConditions(ParameterList const& list);

// Whether a condition in the list, which need not be complete, is of a fault with friction: of a
// Type that is a kind of fault, without a slip rate.
bool haveFriction(ParameterList const& list);
} // namespace asperity::scenario
