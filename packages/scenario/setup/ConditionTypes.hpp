#pragma once

#include "scenario/setup/BoundarySetup.hpp"

#include <string>
#include <tuple>
#include <vector>

namespace asperity::scenario
{
struct BoundaryCondition;

// What all conditions of a deck share.
struct Setting
{
  int components;              // of the displacement
  fem::Boundaries along_fault; // the fault and its continuations
};

enum class Place
{
  fault,
  continuation, // of the fault
  elsewhere
};

// What a condition leaves to others on the same boundary: two may each prescribe a direction, but
// only one the traction, and nothing goes with one that decides on everything.
enum class DecidesOn
{
  direction,
  traction,
  everything
};

// Adds to the result what the deck's condition says.
template <int Dim>
using ConditionMaker = void (*)(BoundaryCondition const&, Setting const&, BoundaryConditions<Dim>&);

// A word for the entry `Type` of a boundary condition.
struct ConditionType
{
  std::string name;
  std::string meaning;            // for the list of parameters
  std::vector<std::string> reads; // entries besides `Boundary` and `Type`
  Place place;
  DecidesOn decides_on;
  std::tuple<ConditionMaker<2>, ConditionMaker<3>> makers;
  fem::OtherSide other_side = {}; // of a fault
};

// All that a deck may choose from, each once: registered kinds of fault and the rest.
std::vector<ConditionType> const& conditionTypes();
ConditionType const& conditionType(std::string const& name);

// One list of the deck's list `Boundary Conditions`, completed.
struct BoundaryCondition
{
  BoundaryCondition(std::string const& path, ParameterList const& completed)
      : name(path)
      , list(completed)
      , type(&conditionType(list.get<std::string>("Type")))
      , boundary(list.get<std::string>("Boundary"))
  {
  }

  std::string name; // its path, for messages
  ParameterList list;
  ConditionType const* type;
  std::string boundary;

  bool liesAlongFault() const { return type->place != Place::elsewhere; }
  bool isFaultInside() const { return type->place == Place::fault && type->other_side.is_inside; }
};
} // namespace asperity::scenario
