#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"

#include <vector>

namespace asperity::bench
{
// How stiff the mesh of a deck makes a plane fault in space, measured at its middle by slip
//   s(x) = cos(k e.x) exp(-|x|^2 / (2 w^2)),   w = 3 / k,
// along a wave vector k e of the plane or across it: the elastic energy of the body in equilibrium,
// against that of a homogeneous half space,
//   1/2 integral of |s^(q)|^2 (A q_s^2 + G q_t^2) / |q| dq / (2 pi)^2
// where q_s and q_t are the parts of q along and across slip, and A is G / (1 - nu) where the other
// side is a mirror image and 4 G (1 - nu) / (3 - 4 nu) on a rigid foundation.
struct WaveErrors
{
  int cells;     // in a wave of length 2 pi / k
  double along;  // relative error for slip along the wave vector (mode II)
  double across; // across it (mode III)
};

struct PlaneStiffness
{
  double cell;   // length around the middle [m], the root of a node's share of the fault
  double extent; // from the middle to the nearest end of the fault [m]
  std::vector<WaveErrors> waves; // of 8, 12, 16 and 24 cells, as far as 3.5 w fit into `extent`
};

// `deck` must be complete, in space, with one plane fault that is a boundary of the body; one rank.
// The rock is that of the middle; the body should be a few waves thick.
PlaneStiffness stiffnessOfPlane(ParameterList const& deck,
                                RCP<const Communicator> const& communicator);
} // namespace asperity::bench
