#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/exact/ExactArrangement.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// A piece of a surface that is removed, and the reason.
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

// Keeps the patches that lie in the body or bound it, which are those inside the box and on or
// below the ground. Of faults it removes the patches whose given points were all moved
// (pushBorders), and stubs: patches that have a free border and less than `stub_share` of the
// fault's area.
//
// InputError if nothing is left of a fault, or ground and walls do not enclose the body.
std::vector<Dropped> keepBody(Arrangement& arrangement, Model const& model,
                              std::vector<std::vector<bool>> const& is_moved, double stub_share);
} // namespace asperity::geometry
