#include "commands/Commands.hpp"
#include "commands/Meshes.hpp"
#include "commands/Partitioning.hpp"

#include "base/Errors.hpp"

namespace asperity::geometry
{
void partition(Arguments& arguments)
{
  Partitioning partitioning;
  std::string target;
  partitioning.declare(arguments);
  arguments.value("--output", target, "OUT.h5", "the file to be made");
  arguments.overwrite();
  if (!arguments.read({"FILE.h5"})) {
    return;
  }
  ASPERITY_REQUIRE(partitioning.numParts(),
                   "Option --parts is missing: the number of ranks that are to read the mesh.");
  ASPERITY_REQUIRE(!target.empty(), "Option --output is missing: the file to be made.");
  partitioning.check();
  arguments.requireNew(target);
  withMesh(arguments.file(0), [&](auto const& mesh, auto const& parts) {
    partitioning.write(mesh, parts ? parts->options : mesh::PartitionOptions(), target);
  });
}
} // namespace asperity::geometry
