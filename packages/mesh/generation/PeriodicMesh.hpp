#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
// Makes a mesh periodic along an axis (0, 1, 2 for x, y, z): the vertices of boundary `high` become
// those of boundary `low`, of which they have to be the translates, and neither is a boundary any
// more. The period is the distance of the two. Throws InputError if they are not translates of each
// other, facet by facet, or if a cell is as long as half the period: at least three cells are
// needed along the axis.
template <int Dim>
void makePeriodic(GlobalMesh<Dim>& mesh, int axis, std::string const& low, std::string const& high);
} // namespace asperity::mesh
