#pragma once

#include "mesh/file/detail/Hdf5Id.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity::mesh::detail
{
// Writes a new HDF5 file. What fails is remembered until finish().
class Hdf5Writer
{
public:
  enum class Layout
  {
    plain, // that of the oldest HDF5
    sealed // HDF5's own structures have checksums too; strings, for that, have fixed lengths
  };
  explicit Hdf5Writer(std::string const& file_name, Layout layout = Layout::plain);

  void attribute(std::string const& name, int value);
  void attribute(std::string const& name, std::string const& value);
  void attribute(std::string const& name, std::vector<double> const& values);
  void group(std::string const& path);

  // (rows, columns), or (rows) if there are no columns.
  template <class Number>
  void dataset(std::string const& path, Number const* values, std::size_t rows, std::size_t columns)
  {
    write(path, nativeType(Number()), values, rows, columns);
  }
  void dataset(std::string const& path, std::vector<std::string> const& values);

  // Closes the file; false if anything went wrong.
  bool finish();

private:
  void write(std::string const& path, hid_t type, void const* values, std::size_t rows,
             std::size_t columns);
  void writeAttribute(std::string const& name, hid_t type, hid_t space, void const* value);
  void note(bool has_succeeded) { has_succeeded_ = has_succeeded_ && has_succeeded; }

  Hdf5Silence silence_;
  Layout layout_;
  Hdf5Id file_;
  bool has_succeeded_;
};
} // namespace asperity::mesh::detail
