#include "CheckpointSample.hpp"

#include "io/checkpoint/Checkpoint.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <mpi.h>

#include <cmath>
#include <filesystem>
#include <iostream>

// Writes the files of the corpus, as our programs write them, into a folder.
namespace
{
using namespace asperity;
namespace fs = std::filesystem;

template <int Dim>
void writeMeshes(GlobalMesh<Dim> mesh, fs::path const& folder, std::string const& name)
{
  mesh::writeMesh(mesh, folder / (name + ".h5"));
  mesh::splitFaults(mesh, "Mesh");
  const auto owners = mesh::partitionVertices(mesh, 2);
  mesh::writeParts(mesh, owners, 2, {}, folder / (name + "_parts.h5"));
}

void writeAll(fs::path const& folder)
{
  mesh::RectangleShape rectangle;
  rectangle.cells_x = 2;
  rectangle.cells_y = 2;
  auto square = mesh::rectangleMesh(rectangle);
  mesh::addFaults<2>(square,
                     {{"fault", [](Point<2> const& x) { return std::abs(x[1] - 0.5) < 1e-9; }}});
  writeMeshes(square, folder, "square");
  writeMeshes(mesh::boxMesh({}), folder, "box");
  const Teuchos::MpiComm<int> communicator(MPI_COMM_SELF);
  io::writeCheckpoint(folder / "checkpoint.h5", fuzz::sampleArchive(), fuzz::sampleFingerprint(),
                      communicator, fuzz::sampleNodes());
}
} // namespace

int main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: asperity_fuzz_seeds FOLDER\n";
    return 2;
  }
  MPI_Init(&argc, &argv);
  writeAll(argv[1]);
  MPI_Finalize();
  return 0;
}
