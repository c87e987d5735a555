#include "surfaces/FileNames.hpp"
#include "surfaces/SurfaceFile.hpp"
#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/kinds/SurfaceKind.hpp"
#include "surfaces/kinds/Units.hpp"

#include <string>
#include <vector>

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
                   "The triangles are in this file: " + describeFormats<SurfaceFormat>() + ".");
  declare.text(part_name, "",
               "Selects one of several surfaces of the file by its name; '*' takes all of them as "
               "one.");
  return Units::declare(declare).list();
}

TriangleSurface makeSurfaceFile(ParameterList const& list, std::string const& path,
                                SurfaceContext const& context)
{
  const auto units = Units::read(list, path, context);
  // readSurface gets the unit only to compare it with that of the file: points are converted here,
  // after equal points have been merged.
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

class SurfaceFileKind final : public SurfaceKind
{
public:
  std::vector<std::string> sources() const override { return {surface_file}; }
  std::string fileEntry() const override { return surface_file; }
  FileFit fit(std::string const& file_name) const override
  {
    return findFormat<SurfaceFormat>(uncompressedName(file_name)).format != nullptr
             ? FileFit::certain
             : FileFit::none;
  }
  Teuchos::RCP<const ParameterList> entries() const override { return surfaceFileEntries(); }
  TriangleSurface make(ParameterList const& list, std::string const& path,
                       SurfaceContext const& context) const override
  {
    return makeSurfaceFile(list, path, context);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceKindRegistry, "Surface File", SurfaceFileKind)
} // namespace asperity::geometry
