#pragma once

#include "io/parallel/NodeBlocks.hpp"

#include <hdf5.h>

#include <filesystem>
#include <string>

namespace asperity::io::detail
{
// A file with the group `geometry` of a domain (README.md); the index of a series links to it.
struct GeometryFile
{
  std::string name;         // "segments/fault_geometry.h5", relative to the folder of the index
  hsize_t num_elements = 0; // of `connectivity`
  hsize_t num_whole = 0;    // elements that do not reach across a period, `whole_elements`

  bool isPeriodic() const { return num_whole < num_elements; }
};

// Writes the geometry of the series `name` below the folder of its index; every rank writes its
// part. The file is the same on any number of ranks: elements are in the order of their nodes'
// numbers. Collective.
GeometryFile writeGeometry(std::filesystem::path const& directory, std::string const& name,
                           OutputDomain const& domain, NodeBlocks const& blocks);
} // namespace asperity::io::detail
