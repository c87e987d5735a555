#pragma once

#include "base/hdf5/File.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity
{
// A one-dimensional HDF5 dataset with one number per global vertex, named
// "file.h5:/path/to/dataset".
class VertexDataset
{
public:
  // Whether the text of a field has this form rather than that of an expression.
  static bool isName(std::string const& text);

  // Looks for file and dataset; InputError with `path` if one is not there or has not one
  // dimension.
  VertexDataset(std::string const& name, std::string const& path);

  // Values of these ids, in their order. InputError unless there are num_vertices values: it is
  // another mesh's then.
  std::vector<double> read(std::vector<long long> const& global_ids, long long num_vertices) const;

  // Of all values; reads them in blocks.
  std::uint64_t checksum() const;

  std::string const& name() const { return name_; }

private:
  h5::Dataset open() const;

  std::string name_, path_, file_name_, dataset_name_;
  long long size_ = 0;
};
} // namespace asperity
