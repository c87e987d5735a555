#pragma once

#include "hdf5/File.hpp"
#include "io/FieldRegistry.hpp"
#include "io/OutputDomain.hpp"
#include "io/series/SegmentedTable.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::io
{
// The properties that the index, the segments and the XDMF file of a history share.
struct SeriesLayout
{
  std::filesystem::path directory;
  std::string name;
  h5::Type type = h5::Type::float64;
  hsize_t num_nodes = 0;
  hsize_t num_elements = 0; // 0 unless a field has values in elements
  int dimension = 0;
  int nodes_per_element = 0;
  std::vector<OutputField> fields;

  // (num_nodes) or (num_nodes, components), or the same with the elements
  h5::Shape rowShape(OutputField const& field) const;
};

// (num_points), or (num_points, components) if there is more than one component.
h5::Shape rowShape(std::size_t num_points, int components);

// The names of a field's components in one text: "xx xy yy".
std::string componentsText(OutputField const& field);

// The columns `time` and `step`.
std::vector<SegmentedTable::Column> timeColumns();

// Writes a dataset of double or GlobalOrdinal with its unit and description.
template <class T>
void writeDataset(h5::File& file, std::string const& path, std::vector<T> const& values,
                  h5::Shape const& shape, std::string const& unit, std::string const& description);
} // namespace asperity::io
