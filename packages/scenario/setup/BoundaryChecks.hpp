#pragma once

#include "base/parameters/Parameters.hpp"
#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// One list of the deck's list `Boundary Conditions`, completed.
struct BoundaryCondition
{
  std::string name; // its path, for messages
  ParameterList list;

  std::string type() const { return list.get<std::string>("Type"); }
  std::string boundary() const { return list.get<std::string>("Boundary"); }
  bool isFault() const { return type() == "Bilateral Contact" || type() == "Antisymmetric Fault"; }
  bool hasSlipRate() const { return type() == "Prescribed Slip Rate"; }
  bool liesAlongFault() const { return isFault() || hasSlipRate(); }
};

// In the order of the deck.
std::vector<BoundaryCondition> readConditions(ParameterList const& list);

// InputError with both names where two conditions on a boundary exclude each other: a free surface
// and a fixed boundary exclude everything, what lies along the fault everything else that does and
// dashpots, and dashpots are there once.
void refuseContradictions(std::vector<BoundaryCondition> const& conditions);

// InputError for an entry that the condition's Type does not read.
void refuseUnreadEntries(std::vector<BoundaryCondition> const& conditions);

// InputError with the nearest name for a boundary that the mesh does not have. The names are the
// same on all ranks.
template <int Dim>
void requireBoundaries(ParameterList const& list, Mesh<Dim> const& mesh);
} // namespace asperity::scenario
