#pragma once

#include "commands/Arguments.hpp"

#include "mesh/GlobalMesh.hpp"
#include "mesh/parallel/Partition.hpp"

#include <optional>
#include <string>

namespace asperity::geometry
{
// The options by which a command divides a mesh into parts for ranks.
class Partitioning
{
public:
  // --parts, --boundary and --boundary-weight. This object has to outlive the arguments.
  void declare(Arguments& arguments);
  // InputError for numbers below 1, and for the other two options without --parts.
  void check() const;

  std::optional<int> const& numParts() const { return num_parts_; }

  // Divides a mesh that is split along its faults, writes the parts and prints how even they are.
  // `former`: what the options replace.
  template <int Dim>
  void write(GlobalMesh<Dim> const& split, mesh::PartitionOptions former,
             std::string const& target) const;

private:
  std::optional<int> num_parts_, weight_;
  std::string boundary_;
};
} // namespace asperity::geometry
