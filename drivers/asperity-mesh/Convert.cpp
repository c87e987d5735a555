#include "Arguments.hpp"
#include "Commands.hpp"
#include "GmshFile.hpp"

#include "mesh/file/MeshFile.hpp"

#include <iostream>

namespace
{
template <int Dim>
void convertMesh(GmshFile const& source, std::string const& file_name)
{
  const auto mesh = source.mesh<Dim>();
  asperity::mesh::writeMesh(mesh, file_name);
  std::cout << file_name << ": " << mesh.vertices.size() << " vertices, " << mesh.cells.size()
            << " cells, " << mesh.region_names.size() << " regions, " << mesh.boundaries.size()
            << " boundaries\n";
}
} // namespace

void convert(std::vector<std::string> const& words)
{
  const auto arguments = parseArguments(words, {{"IN.msh", "OUT.h5"}, {}, {"--overwrite"}});
  requireNew(arguments.files[1], arguments);
  const GmshFile source(arguments.files[0]);
  if (source.dimension() == 2) {
    convertMesh<2>(source, arguments.files[1]);
  } else {
    convertMesh<3>(source, arguments.files[1]);
  }
}
