#pragma once

#include "surfaces/TriangleSurface.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// One surface of a file, in the file's own units, as it stands there: points may be repeated.
struct SurfacePart
{
  std::string name;
  TriangleSurface surface;
  double unit = 0; // [m] that the file names; 0 if it names none
};

// A format of files. To add one: a file with its reader, a declaration here and a line in the
// table of SurfaceFile.cpp. Readers refuse what is no finite number and indices out of range by
// InputError with file, line or byte, and what is expected there.
using SurfaceReader = std::vector<SurfacePart> (*)(std::string const& file_name);

std::vector<SurfacePart> readGocad(std::string const& file_name);
std::vector<SurfacePart> readStl(std::string const& file_name);
std::vector<SurfacePart> readOff(std::string const& file_name);
std::vector<SurfacePart> readObj(std::string const& file_name);
std::vector<SurfacePart> readPly(std::string const& file_name);

// Adds the triangles of a convex polygon, a fan from its first corner.
void addPolygon(TriangleSurface& surface, std::vector<int> const& corners);
} // namespace asperity::geometry
