#include "MeshFormat.hpp"

#include "../GmshFile.hpp"
#include "../GmshGeometry.hpp"
#include "../TemporaryFolder.hpp"

#include <optional>
#include <string>
#include <vector>

namespace
{
// Meshes of Gmsh, and its geometries, which Gmsh meshes.
class Gmsh final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".msh", geometry}; }
  bool isGeometry(std::string const& ending) const override { return ending == geometry; }

  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    const std::string name = "'" + file_name + "'";
    if (::isGeometry(file_name)) {
      std::optional<TemporaryFolder> folder; // made when needed: meshing may be interrupted
      const auto target = [&] { return folder.emplace(options.target).file("mesh.msh"); };
      return meshOf({meshGeometry(file_name, options.settings, options.names,
                                  options.assembly.simplices, target),
                     "Gmsh geometry " + name, options.names},
                    options.assembly);
    }
    const GmshFile source(file_name, "Mesh file " + name, options.names);
    printRemarks(source.groups());
    return meshOf(source, options.assembly);
  }

private:
  static constexpr char const* geometry = ".geo";

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
