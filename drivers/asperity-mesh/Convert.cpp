#include "Commands.hpp"
#include "GmshFile.hpp"
#include "Meshes.hpp"

namespace
{
template <int Dim>
void convertMesh(GmshFile const& source, std::string const& where, std::string const& file_name)
{
  const auto mesh = source.mesh<Dim>();
  auto split = mesh; // to find faults that cannot be split here, and not when the mesh is used
  asperity::mesh::splitFaults(split, where);
  const std::size_t regions = mesh.region_names.size(), faults = split.faults.size();
  writeAndReport(mesh, file_name,
                 ", " + std::to_string(regions) + " regions, " +
                   std::to_string(mesh.boundaries.size() - faults) + " boundaries, " +
                   std::to_string(faults) + " faults");
}
} // namespace

void convert(Arguments& arguments)
{
  std::vector<std::string> settings;
  arguments.values("--set", settings, "NAME=VALUE", "replace a number of DefineConstant in a .geo");
  arguments.overwrite();
  if (!arguments.read({"IN.msh or IN.geo", "OUT.h5"})) {
    return;
  }
  arguments.requireNew(arguments.file(1));
  const GmshFile source(arguments.file(0), settings);
  (source.dimension() == 2 ? convertMesh<2> : convertMesh<3>)(source, "'" + arguments.file(0) + "'",
                                                              arguments.file(1));
}
