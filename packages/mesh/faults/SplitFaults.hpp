#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
// Splits the mesh along all boundaries that lie inside the body, its faults, together. A mesh
// without faults stays as it is.
//
// Which side is which: along a fault, also where another name continues it, all facets are oriented
// alike, and the plus side is the upper one: the mean of the unit normals from minus to plus,
// weighted by area, has n_y > 0; or if |n_y| < 1e-6 |n|, n_x > 0; or else n_z > 0. Plus is the
// hanging wall of a fault that dips and the side with larger x of a vertical one.
//
// What is cut: at a vertex whose cells fall into two sets when the facets of the faults are cut,
// the cells of the plus side get a copy, plus, and all others keep the vertex, minus. At a vertex
// whose cells stay together the fault ends inside the body: a tip. Where the facets of one fault
// divide a side of another one, or only touch it, that fault is a branch, and ends there with a
// tip. Copies are numbered behind the original vertices, in the order of these; cells and facets
// keep their order.
//
// InputError, which starts with `where`, for faults that cross or otherwise need a third copy of a
// vertex, that cannot be oriented, that touch the surface of the body in a single point, or that
// have only tips; for a facet in two faults; for a boundary that is partly inside the body; for a
// periodic mesh.
template <int Dim>
void splitFaults(GlobalMesh<Dim>& mesh, std::string const& where);
} // namespace asperity::mesh
