#pragma once

#include "mesh/file/detail/Hdf5Id.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace asperity::mesh::detail
{
// What mesh files need of HDF5. Whatever is missing or of another kind is an InputError that starts
// with where().
class Hdf5Reader
{
public:
  explicit Hdf5Reader(std::string const& file_name);

  // "Mesh file 'x.h5'"
  std::string const& where() const { return where_; }

  bool has(std::string const& path) const;
  int integerAttribute(std::string const& name) const;
  bool hasAttribute(std::string const& name) const;
  std::string stringAttribute(std::string const& name) const;
  std::vector<double> numbersAttribute(std::string const& name, std::size_t count) const;
  std::vector<std::string> groupEntries(std::string const& path) const; // names, sorted

  std::vector<int> integers(std::string const& path) const; // of a one-dimensional dataset
  std::vector<std::string> strings(std::string const& path) const;

  // Rows of a two-dimensional dataset with that many columns.
  template <std::size_t Columns>
  std::vector<std::array<double, Columns>> numberRows(std::string const& path) const
  {
    std::vector<std::array<double, Columns>> rows;
    readRows(path, Columns, false, H5T_NATIVE_DOUBLE, [&](std::size_t num_rows) {
      rows.resize(num_rows);
      return static_cast<void*>(rows.data());
    });
    return rows;
  }
  template <std::size_t Columns>
  std::vector<std::array<int, Columns>> integerRows(std::string const& path) const
  {
    std::vector<std::array<int, Columns>> rows;
    readRows(path, Columns, true, H5T_NATIVE_INT, [&](std::size_t num_rows) {
      rows.resize(num_rows);
      return static_cast<void*>(rows.data());
    });
    return rows;
  }

private:
  using Destination = std::function<void*(std::size_t num_rows)>;

  // No columns at all means a dataset of one dimension.
  void readRows(std::string const& path, std::size_t columns, bool only_integers, hid_t type,
                Destination const& destination) const;

  Hdf5Silence silence_;
  std::string where_;
  Hdf5Id file_;
};
} // namespace asperity::mesh::detail
