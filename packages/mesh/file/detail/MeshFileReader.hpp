#pragma once

#include "hdf5/File.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace asperity::mesh::detail
{
// Reads attributes, groups and datasets of a mesh file. Throws an InputError that starts with
// where() if one is missing or has another type or shape.
class MeshFileReader
{
public:
  explicit MeshFileReader(std::string const& file_name);

  // "Mesh file 'x.h5'"
  std::string const& where() const { return where_; }

  int dimension() const; // the attribute, 2 or 3
  int integerAttribute(std::string const& name) const;
  bool hasAttribute(std::string const& name) const { return file_.hasAttribute(name); }
  bool hasDataset(std::string const& path) const { return file_.has(path); }
  std::string stringAttribute(std::string const& name) const;
  std::vector<double> numbersAttribute(std::string const& name, std::size_t count) const;
  std::vector<std::string> groupEntries(std::string const& path) const; // names, sorted

  // The rows of a dataset. Throws InputError also if the file is too small for that many rows.
  hsize_t numRows(std::string const& path) const;

  std::vector<int> integers(std::string const& path) const; // of a one-dimensional dataset
  std::vector<std::string> strings(std::string const& path) const;

  // Rows of a two-dimensional dataset with that many columns.
  template <std::size_t Columns>
  std::vector<std::array<double, Columns>> numberRows(std::string const& path) const
  {
    return rows<std::array<double, Columns>, double>(path, Columns, false);
  }
  template <std::size_t Columns>
  std::vector<std::array<int, Columns>> integerRows(std::string const& path) const
  {
    return rows<std::array<int, Columns>, int>(path, Columns, true);
  }

private:
  // columns = 0 means a dataset of one dimension.
  template <class Row, class Number>
  std::vector<Row> rows(std::string const& path, std::size_t columns, bool only_integers) const
  {
    std::vector<Row> values;
    refuseIfUnreadable(path, [&] {
      const h5::Dataset dataset = datasetOf(path, columns, only_integers);
      values.resize(dataset.shape()[0]);
      dataset.read(reinterpret_cast<Number*>(values.data()));
    });
    return values;
  }

  h5::Dataset open(std::string const& path) const;
  h5::Dataset datasetOf(std::string const& path, std::size_t columns, bool only_integers) const;
  void requireAttribute(std::string const& name) const;
  void refuseIfUnreadable(std::string const& path, std::function<void()> const& read) const;

  std::string where_;
  h5::File file_;
};
} // namespace asperity::mesh::detail
