#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
// What a branch has where it ends at a fault that goes on. Along that fault, and at right angles to
// both normals, the three blocks may move without opening a fault: in space along the line at which
// the two meet, in an antiplane model across the plane of the mesh. In plane strain they may not.
enum class BranchEnd
{
  tip,
  joint
};

// Splits the mesh along all its faults, that is, the boundaries inside the body. A mesh without
// faults is not changed.
//
// Sides: along a fault, also where a fault of another name continues it, all facets have the same
// orientation, and the plus side is the upper one: the mean of the unit normals from minus to plus,
// weighted by area, has n_y > 0; or if |n_y| < 1e-6 |n|, n_x > 0; or else n_z > 0. Plus is the
// hanging wall of a dipping fault and the side with larger x of a vertical one. Of a ring, a
// cylinder or a sphere, whole or almost (Facing::isRing), plus is the outside.
//
// Copies: if the facets of the faults divide the cells at a vertex into two sets, the cells of the
// plus side get a copy of the vertex, plus, and all others keep the vertex, minus. If they do not
// divide the cells, the fault ends inside the body: a tip. Faults whose facets divide the cells on
// one side of another fault, or only touch it, are branches. Each ends there with a tip or, if
// branch_end says so and it alone divides the cells on that side, with a joint (Joints.hpp). Where
// two faults cross, each of the four sets of cells has a vertex (Crossings.hpp). In space they
// cross along a line; where it ends inside the body, a fault that goes on is split in two, and the
// other one has a tip on each side of it. Copies are numbered after the original vertices, in the
// order of these; cells and facets keep their order.
//
// Names: two faults that end at one place, where no other fault is, are one fault there, whatever
// the angle at which it bends. Where there are other faults, two that end are one fault if the
// angle between one and the straight continuation of the other is
// - at most 30 degrees, where they lie on opposite sides of a fault that goes on, or where four or
//   more faults end;
// - at most 60 degrees, where three faults end, and at least 10 degrees less than for each other
//   pair of the three. The third one is a branch.
// The vertices that the two share belong to the facets of both.
//
// InputError, which starts with `where`, for three faults that end in one place or meet and go on,
// for faults that otherwise need more copies of a vertex, that touch without crossing, that cannot
// be oriented, that touch the surface of the body in a single point, or that have only tips; for a
// facet in two faults; for a boundary that is partly inside the body; for a periodic mesh.
template <int Dim>
void splitFaults(GlobalMesh<Dim>& mesh, std::string const& where,
                 BranchEnd branch_end = Dim == 3 ? BranchEnd::joint : BranchEnd::tip);
} // namespace asperity::mesh
