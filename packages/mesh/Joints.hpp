#pragma once

#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::mesh
{
// A vertex at which a branch ends at a fault that goes on, and where the branch may slip along the
// other fault: in space a vertex of the line along which they meet, in an antiplane model a point.
// The cells around it lie in three sectors, each of which has a copy of the vertex:
//
//                        branch
//                           |
//       plus of it: `plus`  |  minus of it: `minus`
//                       ----+----  the main fault, the one that goes on
//                       other side
//
// `minus` is the vertex that this side of the main fault would have without the branch: `main`, the
// plus of the main fault, or the minus of that. The facets of the main fault have `main` on both
// sides of the branch, those of the branch have `plus`. FaultSides gives the vertices of the cells.
//
// Among the splits of a mesh a joint is a pair (plus, minus) with is_joint. Each side of the main
// fault has one at most: where several branches end on one side at a vertex, they have tips.
struct Joint
{
  int plus = 0;
  int minus = 0;
  int main = 0;
  bool is_on_plus_side = false; // of the main fault: minus = main
};

// All joints, ascending in plus. The splits pass checkJoints.
std::vector<Joint> jointsOf(std::vector<SplitVertex> const& splits);

// Throws an InputError that starts with `where` if a pair of a joint is not at a pair of another
// fault, or at that of a tip, a crossing or another joint. The pairs consist of vertices of the
// mesh, GlobalMesh or Mesh.
template <class AnyMesh>
void checkJoints(AnyMesh const& mesh, std::string const& where);
} // namespace asperity::mesh
