#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"

#include <string>
#include <vector>

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

// The error of the traction of slip cos(kx) exp(-(kx/5)^2/2) around the node in the middle,
// averaged over this slip. Exact is the traction in an infinite body, to 1e-5.
struct WaveError
{
  int cells = 0;                              // in a wave
  double smallest_cell = 0, largest_cell = 0; // where the slip is more than 1e-4 [m]
  double error = 0;                           // relative
};

// `deck` must be complete, in the plane, with a fault whose two sides deform; one rank.
FaultStiffness stiffnessOfFault(asperity::ParameterList const& deck,
                                asperity::RCP<const asperity::Communicator> const& communicator);

// For waves of 12, 24, 48, ... cells that fit between the ends.
std::vector<WaveError> waveErrors(FaultStiffness const& stiffness);

std::string stiffnessTable(FaultStiffness const& stiffness);
// For numpy.loadtxt: a row for each node, with its position, its weight, the row of `traction` and
// that of `compression`, if there is one.
std::string stiffnessText(FaultStiffness const& stiffness);
