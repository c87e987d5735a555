#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
// A vertex at which two faults of the plane cross. The cells around it lie in four sectors, each of
// which has a copy of the vertex:
//
//                            second
//                               ^
//           plus of both:  both | plus[0]
//                         ------+------>  first, whose plus side is the left one
//       plus of second: plus[1] | mean
//
// Facets are directed as in Mesh, with their plus side on the left. The second fault is the one
// whose facets run to the plus side of the first one. The facets of the first fault have plus[0] on
// both sides of the second one, those of the second fault plus[1]: these two are nodes of the
// faults. FaultSides gives the vertices of the cells.
//
// Among the splits of a mesh a crossing is three pairs without a tip that have the same minus,
// `mean`. Ascending in plus they are those of plus[0], of plus[1] and of `both`.
struct Crossing
{
  int mean = 0;
  std::array<int, 2> plus{};
  int both = 0;
};

// All crossings, ascending in plus[0]. The splits ascend in plus and pass checkCrossings.
std::vector<Crossing> crossingsOf(std::vector<SplitVertex> const& splits);

// Throws an InputError that starts with `where` if pairs without a tip share a minus other than as
// a Crossing in the plane. The pairs consist of vertices of the mesh, GlobalMesh or Mesh.
template <template <int> class AnyMesh, int Dim>
void checkCrossings(AnyMesh<Dim> const& mesh, std::string const& where);

// A crossing by its place [m] and the names of its two faults, the first one first. Two names that
// are one fault there are "east/west".
template <int Dim>
struct NamedCrossing
{
  Point<Dim> place{};
  std::array<std::string, 2> faults;
};

// The crossings of a mesh that is split, in the order of crossingsOf.
template <template <int> class AnyMesh, int Dim>
std::vector<NamedCrossing<Dim>> namedCrossings(AnyMesh<Dim> const& mesh);
} // namespace asperity::mesh
