#pragma once

#include "Warnings.hpp"
#include "surfaces/TriangleSurface.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// Reads a triangulated surface by the extension of the file, in one of the registered formats
// (SurfaceFormat); texts may be compressed (.ts.gz). All coordinates are multiplied by `scale` [m],
// 1000 for a file in km. Points that are equal become one, triangles without area or repeated are
// left out, and `remark` gets a sentence on each such change. Polygons become fans of triangles.
// part: of a file with several surfaces the one of this name, "*" for all of them; "" needs a file
// with one surface. InputError, with file and line or byte, for what is damaged, not finite, out of
// range or empty, and for a part that is not there, with the names of those that are.
TriangleSurface readSurface(std::string const& file_name, double scale,
                            std::string const& part = "", RemarkSink const& remark = warn);

// The names of the surfaces of a file.
std::vector<std::string> partsOfSurface(std::string const& file_name);
} // namespace asperity::geometry
