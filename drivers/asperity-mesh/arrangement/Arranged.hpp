#pragma once

#include "arrangement/Body.hpp"
#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"

#include "mesh/Mesh.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::geometry
{
struct ArrangementOptions
{
  double snap = 0;          // [m], pushBorders
  double stub_share = 0;    // of a fault's area, keepBody
  double short_share = 0.1; // of the size of cells: shorter edges are contracted
};

struct Arranged
{
  Complex complex; // what bounds the body and its faults, ready to be meshed
  std::vector<Dropped> dropped;
  int num_pushed = 0;     // points of borders
  int num_contracted = 0; // corners that became one with another
};

// The size of cells [m] at a place, once the faults are known as far as they are in the body.
using SizeFromFaults =
  std::function<std::function<double(Point<3> const&)>(Complex const& complex)>;

// From surfaces, as checkedSurface makes them, to what bounds the body and its faults. InputError
// as of arrange and keepBody.
Arranged arrangeModel(Model model, ArrangementOptions const& options, SizeFromFaults const& sizes);

// A curve at which two faults meet.
struct Junction
{
  std::string first, second;
  bool is_crossing = false; // both go on; else the second ends at the first, or both end
  double length = 0;        // [m], of all such curves
  Point<3> from{}, to{};    // the ends of one of them
};
std::vector<Junction> junctions(Complex const& complex, Model const& model);

struct AngleAt
{
  double degrees = 180;
  Point<3> place{};
  std::string first, second;
};
// The smallest angle between two surfaces, or two parts of one, at a curve.
AngleAt smallestAngle(Complex const& complex, Model const& model);

struct LengthAt
{
  double length = 0; // [m]
  Point<3> place{};
};
LengthAt shortestCurve(Complex const& complex);
} // namespace asperity::geometry
