#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
// A vertex at which two faults cross, in space one of those on the line along which they do. The
// cells around it lie in four sectors, each of which has a copy of the vertex:
//
//                            second
//                               |
//           plus of both:  both | plus[0]
//                         ------+------  first, whose plus side is the upper one
//       plus of second: plus[1] | mean       (that of the second one is the left one)
//
// The facets of the first fault have plus[0] on both sides of the second one, those of the second
// fault plus[1]: these two are nodes of the faults. FaultSides gives the vertices of the cells.
//
// Among the splits of a mesh a crossing is three pairs that have the same minus, `mean`, and belong
// neither to a tip nor to a joint. Ascending in plus they are those of plus[0], of plus[1] and of
// `both`.
struct Crossing
{
  int mean = 0;
  std::array<int, 2> plus{};
  int both = 0;
};

// All crossings, ascending in plus[0]. The splits ascend in plus and pass checkCrossings.
std::vector<Crossing> crossingsOf(std::vector<SplitVertex> const& splits);

// Throws an InputError that starts with `where` if such pairs share a minus other than as a
// Crossing. The pairs consist of vertices of the mesh, GlobalMesh or Mesh.
template <template <int> class AnyMesh, int Dim>
void checkCrossings(AnyMesh<Dim> const& mesh, std::string const& where);
} // namespace asperity::mesh
