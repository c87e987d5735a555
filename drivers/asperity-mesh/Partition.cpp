#include "Commands.hpp"
#include "Meshes.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/MeshQuality.hpp"

using asperity::formatShort;

void partition(Arguments& arguments)
{
  std::optional<int> num_parts, weight;
  std::string target, boundary;
  const std::string usual = std::to_string(asperity::mesh::PartitionOptions().boundary_weight);
  arguments.number("--parts", num_parts, "number of ranks that are to read the mesh")
    .number("--boundary-weight", weight,
            "how often the vertices of the boundary count in the balance (" + usual + ")")
    .value("--output", target, "OUT.h5", "the file to be made")
    .value("--boundary", boundary, "NAME",
           "the parts get equal shares of the vertices of this boundary, the fault, too");
  arguments.overwrite();
  if (!arguments.read({"FILE.h5"})) {
    return;
  }
  ASPERITY_REQUIRE(num_parts,
                   "Option --parts is missing: the number of ranks that are to read the mesh.");
  ASPERITY_REQUIRE(*num_parts > 0, "Option --parts = " << *num_parts << " is outside [1, inf).");
  ASPERITY_REQUIRE(!target.empty(), "Option --output is missing: the file to be made.");
  ASPERITY_REQUIRE(!weight || *weight > 0,
                   "Option --boundary-weight = " << *weight << " is outside [1, inf).");
  arguments.requireNew(target);
  withMesh(arguments.file(0), [&](auto const& mesh, auto const& parts) {
    auto options = parts ? parts->options : asperity::mesh::PartitionOptions();
    options.boundary = boundary.empty() ? options.boundary : boundary;
    options.boundary_weight = weight.value_or(options.boundary_weight);
    const auto owners = asperity::mesh::partitionVertices(mesh, *num_parts, options);
    asperity::mesh::writeParts(mesh, owners, *num_parts, options, target);
    std::cout << target << ": " << *num_parts << (*num_parts == 1 ? " part of " : " parts of ")
              << mesh.vertices.size() << " vertices, " << mesh.cells.size() << " cells\n"
              << "largest part over the mean: all vertices "
              << formatShort(asperity::mesh::imbalance(owners, *num_parts));
    if (!options.boundary.empty()) {
      const auto vertices = asperity::mesh::boundaryVertices(mesh, options.boundary);
      std::cout << ", those of boundary " << options.boundary << ' '
                << formatShort(asperity::mesh::imbalance(owners, *num_parts, vertices));
    }
    std::cout << '\n';
  });
}
