#pragma once

#include "surfaces/TriangleSurface.hpp"

#include "registry/Registry.hpp"

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

// A format of files with triangulated surfaces. Registered under its name at the end of the
// format's file, which is all that the format needs:
//   ASPERITY_REGISTER(SurfaceFormatRegistry, "OFF", Off)
class SurfaceFormat
{
public:
  static constexpr char const* registered_as = "surface format";
  SurfaceFormat() = default;
  virtual ~SurfaceFormat() = default;
  SurfaceFormat(SurfaceFormat const&) = delete;
  SurfaceFormat& operator=(SurfaceFormat const&) = delete;

  virtual std::vector<std::string> endings() const = 0; // of file names, as ".off"

  // All surfaces of the file. InputError, with file, line or byte, and what is expected there, for
  // what is no finite number and for indices out of range.
  virtual std::vector<SurfacePart> read(std::string const& file_name) const = 0;
};
using SurfaceFormatRegistry = Registry<SurfaceFormat>;

// Adds the triangles of a convex polygon, a fan from its first corner.
void addPolygon(TriangleSurface& surface, std::vector<int> const& corners);
} // namespace asperity::geometry
