#include "surfaces/SurfaceFile.hpp"
#include "surfaces/kinds/SurfaceKind.hpp"
#include "surfaces/kinds/Units.hpp"

namespace asperity::geometry
{
namespace
{
constexpr char const* surface_file = "Surface File";
constexpr char const* part_name = "Part";

Teuchos::RCP<const ParameterList> surfaceFileEntries()
{
  Declare declare;
  declare.fileName(surface_file, required,
                   "The triangles are in this file: GOCAD TSurf (.ts), STL, OFF, OBJ or PLY.");
  declare.text(part_name, "",
               "Selects one of several surfaces of the file by its name; '*' takes all of them as "
               "one.");
  return Units::declare(declare).list();
}

TriangleSurface makeSurfaceFile(ParameterList const& list, std::string const& path,
                                SurfaceContext const& context)
{
  const auto units = Units::read(list, path, context);
  // Points that are welded are equal in the file, so that units come later. The reader compares
  // its unit with that of the file.
  auto surface = readSurface(fileOf(list, surface_file, context), units.horizontal(),
                             list.get<std::string>(part_name), context.remark);
  for (auto& point : surface.points) {
    for (double& x : point) {
      x /= units.horizontal();
    }
  }
  units.toModel(surface.points);
  return surface;
}
} // namespace

SurfaceKind surfaceFileKind()
{
  return {"Surface File", {surface_file}, surfaceFileEntries, makeSurfaceFile};
}
} // namespace asperity::geometry
