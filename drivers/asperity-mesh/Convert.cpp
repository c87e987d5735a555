#include "Arguments.hpp"
#include "Commands.hpp"
#include "GmshFile.hpp"

#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"

#include <iostream>

namespace
{
// Splits a copy of the mesh, to find faults that cannot be split here and not when it is used.
template <int Dim>
std::size_t numFaults(asperity::GlobalMesh<Dim> mesh, std::string const& where)
{
  asperity::mesh::splitFaults(mesh, where);
  return mesh.faults.size();
}

template <int Dim>
void convertMesh(GmshFile const& source, std::string const& where, std::string const& file_name)
{
  const auto mesh = source.mesh<Dim>();
  const auto num_faults = numFaults(mesh, where);
  asperity::mesh::writeMesh(mesh, file_name);
  std::cout << file_name << ": " << mesh.vertices.size() << " vertices, " << mesh.cells.size()
            << " cells, " << mesh.region_names.size() << " regions, "
            << mesh.boundaries.size() - num_faults << " boundaries, " << num_faults << " faults\n";
}
} // namespace

void convert(std::vector<std::string> const& words)
{
  const auto arguments =
    parseArguments(words, {{"IN.msh or IN.geo", "OUT.h5"}, {}, {"--overwrite"}, {"--set"}});
  requireNew(arguments.files[1], arguments);
  const GmshFile source(arguments.files[0], arguments.all("--set"));
  const std::string where = "'" + arguments.files[0] + "'";
  if (source.dimension() == 2) {
    convertMesh<2>(source, where, arguments.files[1]);
  } else {
    convertMesh<3>(source, where, arguments.files[1]);
  }
}
