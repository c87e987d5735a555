#pragma once

#include <string>
#include <vector>

namespace asperity::geometry
{
// Takes out every --plugin FILE of the words, loads these libraries, which register formats of
// meshes (formats/MeshFormat.hpp), and returns the other words. InputError if a value is missing or
// a library cannot be loaded, brings no format, or one that is there already.
std::vector<std::string> loadPlugins(std::vector<std::string> const& words);
} // namespace asperity::geometry
