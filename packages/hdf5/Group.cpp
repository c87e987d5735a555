#include "hdf5/Group.hpp"

#include "hdf5/detail/Calls.hpp"
#include "hdf5/detail/Texts.hpp"

#include <algorithm>
#include <limits>

namespace asperity::h5
{
namespace
{
Handle parentsAreMade(std::string const& what)
{
  Handle properties = makeProperties(H5P_LINK_CREATE, what);
  checked("Making groups for " + what,
          [&] { return H5Pset_create_intermediate_group(properties.get(), 1); });
  return properties;
}

// The shape of an extendable or virtual dataset, which consists of rows.
Shape withRows(hsize_t rows, Shape const& row_shape)
{
  Shape shape{rows};
  shape.insert(shape.end(), row_shape.begin(), row_shape.end());
  return shape;
}

Shape chunkOf(hsize_t rows, Shape const& row_shape)
{
  constexpr hsize_t largest = 131072; // numbers; they have up to 8 bytes
  Shape chunk = withRows(rows, row_shape);
  hsize_t numbers = 1;
  for (const hsize_t length : chunk) {
    numbers *= std::max<hsize_t>(length, 1);
  }
  if (chunk.size() > 1 && numbers > largest) {
    chunk[1] = std::max<hsize_t>(1, largest / (numbers / chunk[1]));
  }
  return chunk;
}

// Sets the value that is read where a part is missing: nan or -1.
void fillGaps(Handle const& properties, Type type, std::string const& what)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::int64_t none = -1;
  const bool is_real = type == Type::float32 || type == Type::float64;
  checked("Filling " + what, [&] {
    return is_real ? H5Pset_fill_value(properties.get(), H5T_NATIVE_DOUBLE, &nan)
                   : H5Pset_fill_value(properties.get(), H5T_NATIVE_INT64, &none);
  });
}

// Maps the part to the rows of the virtual dataset from `first` on.
void mapRows(Handle const& properties, Handle const& space, Shape const& shape, hsize_t first,
             VirtualPart const& part, std::string const& path, std::string const& what)
{
  Shape start(shape.size(), 0), count = shape;
  start[0] = first;
  count[0] = part.num_rows;
  const Handle source = makeSpace(count, count, what);
  checked("Selecting rows of " + what, [&] {
    return H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                               nullptr);
  });
  checked("Mapping " + part.file + " into " + what, [&] {
    return H5Pset_virtual(properties.get(), space.get(), part.file.c_str(), path.c_str(),
                          source.get());
  });
}
// The part of a dataset of this shape that begins at `start`.
Handle selected(Shape const& shape, Shape const& start, Shape const& count, std::string const& what)
{
  Handle space = makeSpace(shape, shape, what);
  checked("Selecting a part of " + what, [&] {
    return H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                               nullptr);
  });
  return space;
}

// The number of columns from `begin` on that show one component after the other.
std::size_t runLength(std::vector<int> const& columns, std::size_t begin)
{
  std::size_t length = 1;
  while (begin + length < columns.size() &&
         columns[begin + length] == columns[begin] + static_cast<int>(length)) {
    ++length;
  }
  return length;
}

// Maps components of the row, one after the other, to the columns from `begin` on.
void mapColumns(Handle const& properties, VirtualRow const& row, std::size_t begin,
                std::size_t length, std::string const& what)
{
  Shape start(row.shape.size(), 0), count(row.shape.size(), 1);
  start[0] = row.row;
  count[1] = row.points;
  if (start.size() > 2) {
    start[2] = static_cast<hsize_t>(row.columns[begin]);
    count[2] = length;
  }
  const Handle source = selected(row.shape, start, count, what);
  const bool has_columns = row.columns.size() > 1;
  const Handle target =
    has_columns ? selected({row.points, row.columns.size()}, {0, begin}, {row.points, length}, what)
                : selected({row.points}, {0}, {row.points}, what);
  checked("Mapping a row of " + row.file + " into " + what, [&] {
    return H5Pset_virtual(properties.get(), target.get(), row.file.c_str(), row.path.c_str(),
                          source.get());
  });
}
} // namespace

// HDF5 demands that every group on the way exists.
bool Group::has(std::string const& path) const
{
  const Silence silence;
  for (auto end = path.find('/', 1);; end = path.find('/', end + 1)) {
    if (H5Lexists(handle_.get(), path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) {
      return false;
    }
    if (end == std::string::npos) {
      return H5Oexists_by_name(handle_.get(), path.c_str(), H5P_DEFAULT) > 0;
    }
  }
}

std::vector<std::string> Group::names() const
{
  const auto collect = [](hid_t, char const* name, H5L_info_t const*, void* names) -> herr_t {
    static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
  };
  std::vector<std::string> names;
  checked("Listing " + what_, [&] {
    return H5Literate(handle_.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names);
  });
  return names;
}

Group Group::createGroup(std::string const& path)
{
  const Handle links = parentsAreMade(describe(path));
  return Group(opened("Creating " + describe(path), H5Gclose,
                      [&] {
                        return H5Gcreate2(handle_.get(), path.c_str(), links.get(), H5P_DEFAULT,
                                          H5P_DEFAULT);
                      }),
               describe(path));
}

Group Group::openGroup(std::string const& path) const
{
  return Group(opened("Opening " + describe(path), H5Gclose,
                      [&] { return H5Gopen2(handle_.get(), path.c_str(), H5P_DEFAULT); }),
               describe(path));
}

Dataset Group::openDataset(std::string const& path) const
{
  return Dataset(opened("Opening " + describe(path), H5Dclose,
                        [&] { return H5Dopen2(handle_.get(), path.c_str(), H5P_DEFAULT); }),
                 describe(path));
}

Dataset Group::createWith(std::string const& path, hid_t type, Handle const& space,
                          Handle const& properties)
{
  const Handle links = parentsAreMade(describe(path));
  return Dataset(opened("Creating " + describe(path), H5Dclose,
                        [&] {
                          return H5Dcreate2(handle_.get(), path.c_str(), type, space.get(),
                                            links.get(), properties.get(), H5P_DEFAULT);
                        }),
                 describe(path));
}

Dataset Group::create(std::string const& path, Type type, Shape const& shape)
{
  return createWith(path, native(type), makeSpace(shape, shape, describe(path)),
                    makeProperties(H5P_DATASET_CREATE, describe(path)));
}

Dataset Group::createTexts(std::string const& path, std::vector<std::string> const& texts,
                           TextLength length)
{
  const std::string what = describe(path);
  const Shape shape{texts.size()};
  const Texts values(texts, length, what);
  Dataset dataset = createWith(path, values.type(), makeSpace(shape, shape, what),
                               makeProperties(H5P_DATASET_CREATE, what));
  checked("Writing " + what, [&] {
    return H5Dwrite(dataset.handle_.get(), values.type(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                    values.data());
  });
  return dataset;
}

void Group::link(std::string const& path, std::string const& file)
{
  checked("Linking " + what_ + ": " + path + " to " + file, [&] {
    return H5Lcreate_external(file.c_str(), ("/" + path).c_str(), handle_.get(), path.c_str(),
                              H5P_DEFAULT, H5P_DEFAULT);
  });
}

Dataset Group::createExtendable(std::string const& path, Type type, Shape const& row_shape,
                                hsize_t rows_per_chunk)
{
  const int compression_level = 4;
  const std::string what = describe(path);
  const Handle properties = makeProperties(H5P_DATASET_CREATE, what);
  const Shape chunk = chunkOf(rows_per_chunk, row_shape);
  checked("Chunking " + what, [&] {
    return H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
  });
  checked("Shuffling " + what, [&] { return H5Pset_shuffle(properties.get()); });
  checked("Compressing " + what,
          [&] { return H5Pset_deflate(properties.get(), compression_level); });
  return createWith(path, native(type),
                    makeSpace(withRows(0, row_shape), withRows(H5S_UNLIMITED, row_shape), what),
                    properties);
}

Dataset Group::createVirtual(std::string const& path, Type type, Shape const& row_shape,
                             std::vector<VirtualPart> const& parts)
{
  hsize_t num_rows = 0;
  for (auto const& part : parts) {
    num_rows += part.num_rows;
  }
  const Shape shape = withRows(num_rows, row_shape);
  if (num_rows == 0) {
    return create(path, type, shape);
  }
  const std::string what = describe(path);
  const Handle space = makeSpace(shape, shape, what);
  const Handle properties = makeProperties(H5P_DATASET_CREATE, what);
  fillGaps(properties, type, what);
  hsize_t first = 0;
  for (auto const& part : parts) {
    if (part.num_rows > 0) { // HDF5 refuses an empty selection
      mapRows(properties, space, shape, first, part, path, what);
      first += part.num_rows;
    }
  }
  checked("Selecting all of " + what, [&] { return H5Sselect_all(space.get()); });
  return createWith(path, native(type), space, properties);
}

Dataset Group::createVirtualRow(std::string const& path, Type type, VirtualRow const& row)
{
  const std::string what = describe(path);
  auto const& columns = row.columns;
  const Shape shape = columns.size() > 1 ? Shape{row.points, columns.size()} : Shape{row.points};
  if (row.points == 0) {
    return create(path, type, shape); // HDF5 refuses an empty selection
  }
  const Handle properties = makeProperties(H5P_DATASET_CREATE, what);
  if (std::find(columns.begin(), columns.end(), -1) == columns.end()) {
    fillGaps(properties, type, what); // else HDF5's own 0 fills the columns of zeros
  }
  for (std::size_t begin = 0; begin < columns.size();) {
    const std::size_t length = columns[begin] < 0 ? 1 : runLength(columns, begin);
    if (columns[begin] >= 0) {
      mapColumns(properties, row, begin, length, what);
    }
    begin += length;
  }
  return createWith(path, native(type), makeSpace(shape, shape, what), properties);
}
} // namespace asperity::h5
