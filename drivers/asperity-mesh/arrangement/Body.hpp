#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/exact/ExactArrangement.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// A piece of a surface that is left out, and why.
struct Dropped
{
  enum class Reason
  {
    outside,  // the box, or above the ground
    pushed,   // across another surface, by pushBorders
    overshoot // a small piece that ends freely behind another surface
  };
  std::string surface;
  bool is_fault = false;
  Reason reason;
  double area; // [m^2]
  Point<3> place;
};

// Keeps what is in the body or bounds it: patches inside the box and, but for the ground itself,
// below the ground; without those of faults whose given points were all moved (pushBorders), and
// without stubs, which have a free border and less than `stub_share` of the fault's area.
//
// InputError if nothing is left of a fault, or ground and walls do not enclose the body.
std::vector<Dropped> keepBody(Arrangement& arrangement, Model const& model,
                              std::vector<std::vector<bool>> const& is_moved, double stub_share);
} // namespace asperity::geometry
