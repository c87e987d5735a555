#include "Arguments.hpp"
#include "Commands.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"

#include <iostream>

namespace
{
using asperity::mesh::PartitionOptions;

// The options of the source's own partition, if it has one, unless others are given.
PartitionOptions optionsFrom(Arguments const& arguments, bool is_partitioned)
{
  PartitionOptions options;
  if (is_partitioned) {
    options = asperity::mesh::partitionSummary(arguments.files[0]).options;
  }
  if (arguments.has("--boundary")) {
    options.boundary = arguments.options.at("--boundary");
  }
  options.boundary_weight = arguments.integer("--boundary-weight", options.boundary_weight);
  ASPERITY_REQUIRE(options.boundary_weight > 0,
                   "Option --boundary-weight = " << options.boundary_weight
                                                 << " is outside [1, inf).");
  return options;
}

int numParts(Arguments const& arguments)
{
  ASPERITY_REQUIRE(arguments.has("--parts"),
                   "Option --parts is missing: the number of ranks that are to read the mesh.");
  const int num_parts = arguments.integer("--parts", 1);
  ASPERITY_REQUIRE(num_parts > 0, "Option --parts = " << num_parts << " is outside [1, inf).");
  return num_parts;
}

std::string outputFile(Arguments const& arguments)
{
  ASPERITY_REQUIRE(arguments.has("--output"), "Option --output is missing: the file to be made.");
  auto const& file_name = arguments.options.at("--output");
  requireNew(file_name, arguments);
  return file_name;
}

template <int Dim>
void partitionMesh(Arguments const& arguments, bool is_partitioned)
{
  const std::string source = arguments.files[0];
  const int num_parts = numParts(arguments);
  const std::string target = outputFile(arguments);
  const auto options = optionsFrom(arguments, is_partitioned);
  auto mesh =
    is_partitioned ? asperity::mesh::readParts<Dim>(source) : asperity::mesh::readMesh<Dim>(source);
  asperity::mesh::splitFaults(mesh, "Mesh file '" + source + "'"); // if they are not split yet
  const auto owners = asperity::mesh::partitionVertices(mesh, num_parts, options);
  asperity::mesh::writeParts(mesh, owners, num_parts, options, target);
  std::cout << target << ": " << num_parts << (num_parts == 1 ? " part of " : " parts of ")
            << mesh.vertices.size() << " vertices, " << mesh.cells.size() << " cells\n"
            << "largest part over the mean: all vertices "
            << asperity::formatShort(asperity::mesh::imbalance(owners, num_parts));
  if (!options.boundary.empty()) {
    const auto vertices = asperity::mesh::boundaryVertices(mesh, options.boundary);
    std::cout << ", those of boundary " << options.boundary << ' '
              << asperity::formatShort(asperity::mesh::imbalance(owners, num_parts, vertices));
  }
  std::cout << '\n';
}
} // namespace

void partition(std::vector<std::string> const& words)
{
  const auto arguments = parseArguments(
    words,
    {{"FILE.h5"}, {"--parts", "--output", "--boundary", "--boundary-weight"}, {"--overwrite"}});
  auto const& file_name = arguments.files[0];
  const bool is_partitioned = asperity::mesh::isPartitioned(file_name);
  const int dimension = is_partitioned ? asperity::mesh::partitionSummary(file_name).dimension
                                       : asperity::mesh::meshDimension(file_name);
  if (dimension == 2) {
    partitionMesh<2>(arguments, is_partitioned);
  } else {
    partitionMesh<3>(arguments, is_partitioned);
  }
}
