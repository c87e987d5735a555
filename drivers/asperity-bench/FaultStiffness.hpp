#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"

#include <vector>

namespace asperity::bench
{
// How slip stresses a fault in the plane whose body is in equilibrium (the condensed stiffness of
// the mesh), at the nodes where friction decides on slip, from the one that lies highest. Traction
// counts along slip, so that it is negative where slip releases it.
struct FaultStiffness
{
  std::vector<double> positions; // (n) distance from the first node [m]
  std::vector<double> weights;   // (n) integrals of the basis functions [m]
  // (n, n) row by row: Pa at a node for a metre of slip at another one. compression is empty where
  // the deck's normal stress does not follow the body.
  std::vector<double> traction, compression;
  double half_plane = 0; // G, in plane strain G / (1 - nu): exact traction of slip cos(kx) is k/2
                         // times this [Pa]

  int size() const { return static_cast<int>(positions.size()); }
};

// `deck` must be complete, in the plane, with a fault whose two sides deform; one rank.
FaultStiffness stiffnessOfFault(ParameterList const& deck,
                                RCP<const Communicator> const& communicator);
} // namespace asperity::bench
