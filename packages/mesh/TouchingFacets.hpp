#pragma once

#include "mesh/GlobalMesh.hpp"

#include <optional>

namespace asperity::mesh
{
// Facets of the surface of the body that lie on other facets of it and are not the same: bodies
// that touch without common vertices, and open cracks. Nothing acts between them.
template <int Dim>
struct TouchingFacets
{
  GlobalOrdinal number = 0;  // of facets of the first region that lie on the second one
  std::string first, second; // regions; may be the same one
  std::string boundary;      // of the first facet found, or ""
  Point<Dim> place{};        // its centroid [m]
};

// The two regions with the most facets that lie on each other; nullopt if there are no such facets.
// A facet lies on another one if its centroid is within a hundredth of both their lengths outside
// it, or within a ten-thousandth inside, and their normals are opposite: the two sides may be
// divided differently. The two sides of a fault do not count. The work is proportional to the
// surface.
template <int Dim>
std::optional<TouchingFacets<Dim>> touchingFacets(GlobalMesh<Dim> const& mesh);

// The same of the parts of a mesh, on every rank. Every rank gets the whole surface for it, so call
// this where something is wrong. Collective.
template <int Dim>
std::optional<TouchingFacets<Dim>> touchingFacets(Mesh<Dim> const& part,
                                                  Communicator const& communicator);

// "34 facets of region 'west' lie on facets of region 'east' without sharing vertices, the first at
// (0, -9700) m, on boundary 'fault'. What to do ..."
template <int Dim>
std::string sentence(TouchingFacets<Dim> const& touching);
} // namespace asperity::mesh
