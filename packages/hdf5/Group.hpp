#pragma once

#include "hdf5/Dataset.hpp"

#include <string>
#include <utility>
#include <vector>

namespace asperity::h5
{
// A piece of a virtual dataset: all `num_rows` rows of a dataset of the same name in `file`, a path
// relative to the folder of the index.
struct VirtualPart
{
  std::string file;
  hsize_t num_rows = 0;
};

// One row of a dataset (rows, points) or (rows, points, components) of another file: its first
// `points` points, and of them the components that `columns` names; -1 is a column of zeros.
struct VirtualRow
{
  std::string file; // relative to the folder of the file that shows the row
  std::string path; // of the dataset
  Shape shape;      // of the dataset
  hsize_t row = 0;
  hsize_t points = 0;
  std::vector<int> columns = {0};
};

// Paths of objects use '/'; missing groups are made.
class Group : public Object
{
public:
  bool has(std::string const& path) const; // false, too, if a link on the way is broken
  std::vector<std::string> names() const;  // of the members, sorted

  Group createGroup(std::string const& path);
  Group openGroup(std::string const& path) const;
  Dataset openDataset(std::string const& path) const;

  // Creates a dataset of fixed shape; `store` also writes its values.
  Dataset create(std::string const& path, Type type, Shape const& shape);
  template <class Number>
  Dataset store(std::string const& path, Number const* values, Shape const& shape)
  {
    Dataset dataset = create(path, typeOf<Number>(), shape);
    dataset.write(values);
    return dataset;
  }

  // A list of texts in UTF-8.
  Dataset createTexts(std::string const& path, std::vector<std::string> const& texts,
                      TextLength length = TextLength::variable);

  // Rows of shape `row_shape` can be appended. The dataset is compressed (shuffle, deflate) in
  // chunks of rows_per_chunk rows, or of parts of rows if a chunk would exceed 1 MiB.
  Dataset createExtendable(std::string const& path, Type type, Shape const& row_shape,
                           hsize_t rows_per_chunk);

  // The rows of the parts, one part after the other. Where a part is missing, nan or -1 is read.
  Dataset createVirtual(std::string const& path, Type type, Shape const& row_shape,
                        std::vector<VirtualPart> const& parts);

  // A row as a dataset of its own, which has no copy of the numbers: (points), or (points, columns)
  // if there are several columns.
  Dataset createVirtualRow(std::string const& path, Type type, VirtualRow const& row);

  // Makes `path` a link to the object of the same path in `file`, a path relative to this file's
  // folder.
  void link(std::string const& path, std::string const& file);

protected:
  Group(Handle handle, std::string what) : Object(std::move(handle), std::move(what)) {}

private:
  Dataset createWith(std::string const& path, hid_t type, Handle const& space,
                     Handle const& properties);
  std::string describe(std::string const& path) const { return what_ + ": " + path; }
};
} // namespace asperity::h5
