#pragma once

#include "mesh/detail/Hdf5Id.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity::mesh::detail
{
// Writes a new HDF5 file. What fails is remembered until finish().
class Hdf5Writer
{
public:
  explicit Hdf5Writer(std::string const& file_name);

  void attribute(std::string const& name, int value);
  void attribute(std::string const& name, std::string const& value);
  void group(std::string const& path);

  // (rows, columns), or (rows) if there are no columns.
  void dataset(std::string const& path, double const* values, std::size_t rows,
               std::size_t columns);
  void dataset(std::string const& path, int const* values, std::size_t rows, std::size_t columns);
  void dataset(std::string const& path, std::vector<std::string> const& values);

  // Closes the file; false if anything went wrong.
  bool finish();

private:
  void write(std::string const& path, hid_t type, void const* values, std::size_t rows,
             std::size_t columns);
  void writeAttribute(std::string const& name, hid_t type, void const* value);
  void note(bool has_succeeded) { has_succeeded_ = has_succeeded_ && has_succeeded; }

  Hdf5Silence silence_;
  Hdf5Id file_;
  bool has_succeeded_;
};
} // namespace asperity::mesh::detail
