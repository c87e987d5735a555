#pragma once

#include "mesh/GlobalMesh.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::geometry
{
// The tetrahedra of Gmsh's model as one region "body". Each boundary has the triangles of the
// surfaces with the tags that are given for its name. Cells and facets are oriented as in Gmsh.
// InputError if a triangle belongs to no tetrahedron.
GlobalMesh<3> meshInGmsh(std::map<std::string, std::vector<int>> const& surfaces);
} // namespace asperity::geometry
