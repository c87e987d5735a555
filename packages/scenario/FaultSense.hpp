#pragma once

#include "scenario/Problem.hpp"

#include <array>
#include <string>
#include <vector>

namespace asperity::scenario
{
// How a fault lies: the mean unit vector from its minus to its plus side, which is that of the body
// where the fault is a boundary of it.
struct FaultSides
{
  std::array<double, 3> plus{};
  int dimension = 2;  // of space
  int components = 2; // of the displacement
  std::array<double, 3> up{0, 1, 0};
  bool is_section = false; // the plane is upright, as gravity acts in it; else it may be a map, too
};

// The sense of positive slip, v+ - v- [m/s], as geologists say it: "moves the plus side along +x,
// down dip: a normal fault in a section, left lateral in a map".
std::string senseOfSlip(FaultSides const& sides);

// That of slip with this sign, in two dimensions: "a thrust in a section, right lateral in a map";
// of a section that is known to be one "a thrust"; antiplane "right lateral seen from above".
std::string senseInWords(FaultSides const& sides, double slip);

// A line for the fault, which says where its plus side is and what slip is positive, and one for
// the plates' motion along it, if the deck has one in two dimensions. Collective.
template <int Dim>
std::vector<std::string> describeSense(Problem<Dim> const& problem, ParameterList const& deck);
} // namespace asperity::scenario
