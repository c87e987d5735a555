#pragma once

#include "hdf5/File.hpp"

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

  // InputError with `path` unless the file and the dataset exist and the dataset has one dimension.
  VertexDataset(std::string const& name, std::string const& path);

  // The values of these ids, in their order. InputError if the number of values is not
  // num_vertices: the dataset then belongs to another mesh.
  std::vector<double> read(std::vector<long long> const& global_ids, long long num_vertices) const;

  // All values, without a mesh. InputError if the dataset has an attribute `unit` that is another.
  std::vector<double> readAll(std::string const& unit) const;

  // The checksum of all values, which are read in blocks.
  std::uint64_t checksum() const;

  std::string const& name() const { return name_; }

private:
  h5::Dataset open() const;

  std::string name_, path_, file_name_, dataset_name_;
  long long size_ = 0;
};
} // namespace asperity
