#pragma once

#include "mesh/Mesh.hpp"

#include <array>
#include <string>
#include <vector>

namespace asperity::mesh
{
// How the facets of a boundary or a fault, of one orientation, face all together. Integrals are
// over the facets, n is their unit normal, and c is their centre.
struct Facing
{
  std::array<double, 3> normal{}; // of n [m^(Dim-1)]
  double measure = 0;             // [m^(Dim-1)]
  double outwards = 0;            // of (x - c) . n [m^Dim]
  double extent = 0;              // of |x - c| [m^Dim]

  // Whether the mean of n is more than rounding.
  bool hasMeanNormal() const;
  // Whether the mean of n is so short that it says little about any part.
  bool partsFaceEachOther() const;
  // Whether the parts face each other since they lie around the centre, as those of a circle, a
  // cylinder or a sphere, whole or almost. An S is no ring, though its parts face each other.
  bool isRing() const;
};

// Of facets by their corners, on this rank alone.
template <int Dim>
Facing facingOf(std::vector<std::array<Point<Dim>, Dim>> const& facets);

// Of the facets of boundaries that the mesh has, on all ranks. n points out of the body, at faults
// inside the body out of their plus side. Collective.
template <int Dim>
Facing facingOf(Mesh<Dim> const& mesh, std::vector<std::string> const& boundaries,
                Communicator const& communicator);
} // namespace asperity::mesh
