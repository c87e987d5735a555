#pragma once

#include "io/catalogue/fault_geometry/FaultPlane.hpp"

#include <vector>

namespace asperity::io::detail
{
// Where the nodes of the fault are on a platform, by node number, on rank 0; empty elsewhere.
//
// Of a surface in its mean plane. Of a curve, the distance along it is along strike where the curve
// is level, because the plane of the mesh is a map then, otherwise down dip; the other one is zero.
struct FaultPlaces
{
  std::vector<double> along_strike; // [m]
  std::vector<double> down_dip;     // [m]
};

// Collective.
FaultPlaces faultPlaces(Location const& fault, Direction const& up);
} // namespace asperity::io::detail
