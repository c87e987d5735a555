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
  Complex complex; // the boundary of the body and its faults
  std::vector<Dropped> dropped;
  int num_pushed = 0;     // points of borders
  int num_contracted = 0; // corners that were moved onto others
};

// Gives the size of cells [m] as a function of the place, from the parts of faults in the body.
using SizeFromFaults =
  std::function<std::function<double(Point<3> const&)>(Complex const& complex)>;

// Cuts surfaces, as checkedSurface makes them, along their intersections, and keeps the boundary of
// the body and its faults. InputError as of arrange and keepBody.
Arranged arrangeModel(Model model, ArrangementOptions const& options, SizeFromFaults const& sizes);

// A curve at which two faults meet.
struct Junction
{
  std::string first, second;
  bool is_crossing = false; // both continue beyond it; else the second one, or both, end there
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
