#pragma once

#include "io/FieldRegistry.hpp"
#include "io/H5.hpp"
#include "io/detail/NodeGather.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity::io::detail
{
// What the files of a segmented series have in common.
struct SeriesLayout
{
  std::filesystem::path directory;
  std::string name;
  std::string location;
  h5::Type type = h5::Type::float64;
  hsize_t num_nodes = 0;
  int dimension = 0;
  int nodes_per_element = 0;
  std::vector<Field> fields;

  std::string segmentName(std::size_t segment) const; // relative: "segments/fault_000012.h5"
  h5::Shape rowShape(Field const& field) const;       // (num_nodes) or (num_nodes, components)
};

// The numbers of the segment files of this series in `directory`, or an empty list.
std::vector<std::size_t> segmentsOnDisk(SeriesLayout const& layout);

// DIR/<name>.h5, replaced atomically. rows_of_segment: for each closed segment. On rank 0.
void writeIndexFile(SeriesLayout const& layout, WholeGeometry const& geometry,
                    std::vector<std::int64_t> const& rows_of_segment);

// Names `dataset`'s unit and meaning in its attributes.
void describe(h5::Dataset dataset, std::string const& unit, std::string const& description);
} // namespace asperity::io::detail
