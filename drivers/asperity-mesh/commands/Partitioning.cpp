#include "commands/Partitioning.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/file/PartitionedFile.hpp"

#include <iostream>

namespace asperity::geometry
{
void Partitioning::declare(Arguments& arguments)
{
  const std::string usual = std::to_string(mesh::PartitionOptions().boundary_weight);
  arguments.number("--parts", num_parts_, "number of ranks that are to read the mesh")
    .number("--boundary-weight", weight_,
            "how often the vertices of the boundary count in the balance (" + usual + ")")
    .value("--boundary", boundary_, "NAME",
           "the parts get equal shares of the vertices of this boundary, the fault, too");
}

void Partitioning::check() const
{
  ASPERITY_REQUIRE(!num_parts_ || *num_parts_ > 0,
                   "Option --parts = " << *num_parts_ << " is outside [1, inf).");
  ASPERITY_REQUIRE(!weight_ || *weight_ > 0,
                   "Option --boundary-weight = " << *weight_ << " is outside [1, inf).");
  ASPERITY_REQUIRE(num_parts_ || (!weight_ && boundary_.empty()),
                   "Option --parts is missing: the number of ranks that are to read the mesh.");
}

template <int Dim>
void Partitioning::write(GlobalMesh<Dim> const& split, mesh::PartitionOptions options,
                         std::string const& target) const
{
  const int number = *num_parts_;
  options.boundary = boundary_.empty() ? options.boundary : boundary_;
  options.boundary_weight = weight_.value_or(options.boundary_weight);
  const auto owners = mesh::partitionVertices(split, number, options);
  mesh::writeParts(split, owners, number, options, target);
  std::cout << target << ": " << number << (number == 1 ? " part of " : " parts of ")
            << split.vertices.size() << " vertices, " << split.cells.size() << " cells\n"
            << "largest part over the mean: all vertices "
            << formatShort(mesh::imbalance(owners, number));
  if (!options.boundary.empty()) {
    const auto vertices = mesh::boundaryVertices(split, options.boundary);
    std::cout << ", those of boundary " << options.boundary << ' '
              << formatShort(mesh::imbalance(owners, number, vertices));
  }
  std::cout << '\n';
}

template void Partitioning::write(GlobalMesh<2> const&, mesh::PartitionOptions,
                                  std::string const&) const;
template void Partitioning::write(GlobalMesh<3> const&, mesh::PartitionOptions,
                                  std::string const&) const;
} // namespace asperity::geometry
