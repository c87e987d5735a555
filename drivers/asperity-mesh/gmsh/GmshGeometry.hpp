#pragma once

#include "assembly/GroupNames.hpp"
#include "gmsh/GmshGroups.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// Meshes a geometry, a script that Gmsh runs, in its own dimension, 2 or 3, and has Gmsh write the
// mesh to the file target(), which is called when the mesh is there, and is returned. The mesh is
// what Gmsh's own program would save: what the script asks for then, such as Mesh.ScalingFactor and
// Mesh.SaveAll, holds. Gmsh's progress goes to the terminal. `settings` are NAME=VALUE each, for
// the script's DefineConstant[name = value, name = {value, ...}, ...].
//
// InputError, before the mesh is made, if the script does not define one of the constants (with the
// nearest name), a value is no number, a name is given twice, the file cannot be read, it or a
// script that it includes runs programs (SystemCall) or has statements that Gmsh passes over, its
// physical groups are wrong (GmshGroups.hpp) or it asks for cells that are no linear simplices,
// unless others are `allowed`; after that, if Gmsh cannot mesh it. OutputError if the target
// cannot be written.
std::string meshGeometry(std::string const& file_name, std::vector<std::string> const& settings,
                         GroupNames const& names, bool allowed,
                         std::function<std::string()> const& target);

// Prints the remarks and the warnings.
void printRemarks(PhysicalGroups const& groups);
} // namespace asperity::geometry
