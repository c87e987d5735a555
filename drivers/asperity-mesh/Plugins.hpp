#pragma once

#include <string>
#include <vector>

namespace asperity::geometry
{
// What there is of all that a library may add: formats of meshes (formats/MeshFormat.hpp), of
// surfaces (surfaces/files/SurfaceFormat.hpp) and of grids (surfaces/grids/GridFormat.hpp), and
// kinds of surface (surfaces/kinds/SurfaceKind.hpp), as "mesh format 'Gmsh'". A name that is
// registered twice occurs twice.
std::vector<std::string> registrations();

// Takes out every --plugin FILE of the words, loads these libraries, and returns the other words.
// InputError if a value is missing or a library cannot be loaded, registers nothing, or registers a
// name that is taken.
std::vector<std::string> loadPlugins(std::vector<std::string> const& words);
} // namespace asperity::geometry
