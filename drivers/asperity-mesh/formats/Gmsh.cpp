#include "FormatChoice.hpp"
#include "TemporaryFolder.hpp"
#include "formats/MeshFormat.hpp"
#include "gmsh/GmshFile.hpp"
#include "gmsh/GmshGeometry.hpp"

#include "base/Errors.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
// Meshes of Gmsh, and its geometries, which Gmsh meshes.
class Gmsh final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".msh", geometry}; }

  std::vector<FormatOption> ownOptions() const override
  {
    return {{set_option, "NAME=VALUE",
             "replace a number of DefineConstant in a .geo, which Gmsh executes: trust it first",
             true}};
  }

  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    const std::string name = "'" + file_name + "'";
    const auto settings = options.valuesOf(set_option);
    if (hasEnding(file_name, geometry)) {
      std::optional<TemporaryFolder> folder; // made when needed: meshing may be interrupted
      const auto target = [&] { return folder.emplace(options.target).file("mesh.msh"); };
      return meshOf(
        {meshGeometry(file_name, settings, options.names, options.assembly.simplices, target),
         "Gmsh geometry " + name, options.names},
        options.assembly);
    }
    ASPERITY_REQUIRE(settings.empty(), "Option " << set_option << " " << settings.front()
                                                 << ": mesh file " << name
                                                 << " is no geometry (.geo), but a mesh.");
    const GmshFile source(file_name, "Mesh file " + name, options.names);
    printRemarks(source.groups());
    return meshOf(source, options.assembly);
  }

private:
  static constexpr char const* geometry = ".geo";
  static constexpr char const* set_option = "--set";

  static AnyMesh meshOf(GmshFile const& source, AssemblyOptions options)
  {
    options.without.clear(); // the groups of the source are without them

    if (source.dimension() == 2) {
      return source.mesh<2>(options);
    }
    return source.mesh<3>(options);
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "Gmsh", Gmsh)
} // namespace asperity::geometry
