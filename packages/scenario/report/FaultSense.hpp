#pragma once

#include "scenario/setup/Vector3.hpp"

#include <string>

namespace asperity::scenario
{
// How a fault lies: the mean unit vector from its minus to its plus side, which is that of the body
// where the fault is a boundary of it.
struct FaultSides
{
  Vector3 plus{};
  int dimension = 2;  // of space
  int components = 2; // of the displacement
  Vector3 up{0, 1, 0};
  bool is_section = false; // the plane is upright, as gravity acts in it; else it may be a map, too
  // In plane strain: the mean tangent, along which slip is positive. If it is zero, the tangent
  // that follows from `plus` counts.
  Vector3 tangent{};
  Vector3 east{1, 0, 0}; // in space; its part at right angles to `up` counts

  Vector3 slipTangent() const; // in plane strain
};

// "(0, -1)": a unit vector, to two digits.
std::string directionText(Vector3 const& v, int dimension);

// The sense of positive slip, v+ - v- [m/s], as geologists say it: "moves the plus side along +x,
// down dip: a normal fault in a section, left lateral in a map".
std::string senseOfSlip(FaultSides const& sides);

// The sense of slip with this sign, in two dimensions: "a thrust in a section, right lateral in a
// map"; in a section that is known to be one "a thrust"; antiplane "right lateral seen from above".
std::string senseInWords(FaultSides const& sides, double slip);

// Strike and dip of a fault in space, in degrees, as Aki and Richards define them: the strike
// counts clockwise from north, and the fault dips to its right. The plus side of a vertical fault
// counts as its hanging wall; a level one has no strike.
struct StrikeAndDip
{
  bool is_level = false;
  double strike = 0, dip = 0;
};
StrikeAndDip strikeAndDip(FaultSides const& sides);

// The rake of slip along a vector, of which the part along the fault counts: the angle in degrees,
// in (-180, 180], from the strike to the motion of the hanging wall, 90 up dip. Not for level ones.
double rakeOf(FaultSides const& sides, Vector3 const& slip);

// "rake 180, right lateral", "rake 45, left lateral and a thrust"; nothing if no part of the vector
// is along the fault, or if the fault is level.
std::string rakeInWords(FaultSides const& sides, Vector3 const& slip);
} // namespace asperity::scenario
