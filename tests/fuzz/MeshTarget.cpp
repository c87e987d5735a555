#include "FuzzTarget.hpp"

#include "FileRecipe.hpp"

#include "hdf5/File.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"

// The input is a mesh file, whole or partitioned, or a recipe of one (FileRecipe.hpp).
namespace asperity::fuzz
{
namespace
{
template <int Dim>
void readBoth(std::string const& path, bool is_partitioned)
{
  if (is_partitioned) {
    mesh::readParts<Dim>(path);
  } else {
    auto mesh = mesh::readMesh<Dim>(path);
    mesh::splitFaults(mesh, "Mesh");
  }
}
} // namespace

void tryInput(std::string const& input)
{
  const Scratch file("mesh.h5");
  if (!makeFile(input, file)) {
    return;
  }
  if (!isRecipe(input) && !h5::File::isSealed(file.path())) {
    return; // HDF5 1.10.8 crashes on damaged files of its old format (README.md)
  }
  const bool is_partitioned = mesh::isPartitioned(file.path());
  const int dimension = is_partitioned ? mesh::partitionSummary(file.path()).dimension
                                       : mesh::meshDimension(file.path());
  if (dimension == 2) {
    readBoth<2>(file.path(), is_partitioned);
  } else {
    readBoth<3>(file.path(), is_partitioned);
  }
}
} // namespace asperity::fuzz
