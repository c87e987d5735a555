#include "base/hdf5/H5.hpp"

#include "base/hdf5/detail/H5Calls.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace asperity::h5
{
namespace
{
hid_t native(Type type)
{
  switch (type) {
  case Type::int8: return H5T_NATIVE_INT8;
  case Type::int64: return H5T_NATIVE_INT64;
  case Type::float32: return H5T_NATIVE_FLOAT;
  case Type::float64: break;
  }
  return H5T_NATIVE_DOUBLE;
}

Handle parentsAreMade(std::string const& what)
{
  Handle properties = makeProperties(H5P_LINK_CREATE, what);
  check(H5Pset_create_intermediate_group(properties.get(), 1), "Making groups for " + what);
  return properties;
}

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

// Selects `num_rows` rows from `first` on.
void selectRows(Handle const& space, Shape shape, hsize_t first, hsize_t num_rows,
                std::string const& what)
{
  Shape start(shape.size(), 0);
  start[0] = first;
  shape[0] = num_rows;
  check(
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr),
    "Selecting rows of " + what);
}
} // namespace

Type Dataset::type() const
{
  const Handle type(H5Dget_type(handle_.get()), H5Tclose, "Asking the type of " + what_);
  const std::size_t size = H5Tget_size(type.get());
  if (H5Tget_class(type.get()) == H5T_FLOAT) {
    return size == 4 ? Type::float32 : Type::float64;
  }
  return size == 1 ? Type::int8 : Type::int64;
}

Shape Dataset::shape() const
{
  const Handle space(H5Dget_space(handle_.get()), H5Sclose, "Asking the shape of " + what_);
  Shape shape(std::max(0, H5Sget_simple_extent_ndims(space.get())));
  check(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr),
        "Asking the shape of " + what_);
  return shape;
}

std::size_t Dataset::numValues() const
{
  const Shape all = shape();
  return std::accumulate(all.begin(), all.end(), std::size_t(1), std::multiplies<>());
}

void Dataset::write(double const* values)
{
  check(H5Dwrite(handle_.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
        "Writing " + what_);
}

void Dataset::write(std::int64_t const* values)
{
  check(H5Dwrite(handle_.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
        "Writing " + what_);
}

void Dataset::write(std::int8_t const* values)
{
  check(H5Dwrite(handle_.get(), H5T_NATIVE_INT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
        "Writing " + what_);
}

std::vector<double> Dataset::readDoubles() const
{
  std::vector<double> values(numValues());
  check(H5Dread(handle_.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "Reading " + what_);
  return values;
}

std::vector<std::int64_t> Dataset::readIntegers() const
{
  std::vector<std::int64_t> values(numValues());
  check(H5Dread(handle_.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "Reading " + what_);
  return values;
}

std::string Dataset::readBytes() const
{
  std::string values(numValues(), '\0');
  check(H5Dread(handle_.get(), H5T_NATIVE_INT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "Reading " + what_);
  return values;
}

std::vector<std::string> Dataset::readTexts() const
{
  const Handle type = makeTextType(what_);
  std::vector<char*> pointers(numValues(), nullptr);
  check(H5Dread(handle_.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()),
        "Reading " + what_);
  std::vector<std::string> texts;
  for (char* pointer : pointers) {
    texts.emplace_back(pointer ? pointer : "");
    H5free_memory(pointer);
  }
  return texts;
}

void Dataset::append(double const* values, hsize_t num_rows)
{
  appendRaw(values, H5T_NATIVE_DOUBLE, num_rows);
}

void Dataset::append(std::int64_t const* values, hsize_t num_rows)
{
  appendRaw(values, H5T_NATIVE_INT64, num_rows);
}

void Dataset::appendRaw(void const* values, hid_t memory_type, hsize_t num_rows)
{
  Shape extended = extend(num_rows);
  const hsize_t first = extended[0] - num_rows;
  const Handle file_space(H5Dget_space(handle_.get()), H5Sclose, "Asking the shape of " + what_);
  selectRows(file_space, extended, first, num_rows, what_);
  extended[0] = num_rows;
  const Handle memory_space = makeSpace(extended, extended, what_);
  check(
    H5Dwrite(handle_.get(), memory_type, memory_space.get(), file_space.get(), H5P_DEFAULT, values),
    "Writing " + what_);
}

Shape Dataset::extend(hsize_t num_rows)
{
  Shape extended = shape();
  extended[0] += num_rows;
  check(H5Dset_extent(handle_.get(), extended.data()), "Extending " + what_);
  return extended;
}

Group Group::createGroup(std::string const& path)
{
  const Handle links = parentsAreMade(describe(path));
  return Group(
    Handle(H5Gcreate2(handle_.get(), path.c_str(), links.get(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
           "Creating " + describe(path)),
    describe(path));
}

Group Group::openGroup(std::string const& path) const
{
  return Group(Handle(H5Gopen2(handle_.get(), path.c_str(), H5P_DEFAULT), H5Gclose,
                      "Opening " + describe(path)),
               describe(path));
}

Dataset Group::openDataset(std::string const& path) const
{
  return Dataset(Handle(H5Dopen2(handle_.get(), path.c_str(), H5P_DEFAULT), H5Dclose,
                        "Opening " + describe(path)),
                 describe(path));
}

Dataset Group::createWith(std::string const& path, hid_t type, Handle const& space,
                          Handle const& properties)
{
  const Handle links = parentsAreMade(describe(path));
  return Dataset(Handle(H5Dcreate2(handle_.get(), path.c_str(), type, space.get(), links.get(),
                                   properties.get(), H5P_DEFAULT),
                        H5Dclose, "Creating " + describe(path)),
                 describe(path));
}

Dataset Group::create(std::string const& path, Type type, Shape const& shape)
{
  return createWith(path, native(type), makeSpace(shape, shape, describe(path)),
                    makeProperties(H5P_DATASET_CREATE, describe(path)));
}

Dataset Group::createTexts(std::string const& path, std::vector<std::string> const& texts)
{
  const std::string what = describe(path);
  const Shape shape{texts.size()};
  const Handle type = makeTextType(what);
  Dataset dataset = createWith(path, type.get(), makeSpace(shape, shape, what),
                               makeProperties(H5P_DATASET_CREATE, what));
  std::vector<char const*> pointers;
  for (auto const& text : texts) {
    pointers.push_back(text.c_str());
  }
  check(H5Dwrite(dataset.handle_.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()),
        "Writing " + what);
  return dataset;
}

Dataset Group::createExtendable(std::string const& path, Type type, Shape const& row_shape,
                                hsize_t rows_per_chunk, bool shared)
{
  const int compression_level = 4;
  const std::string what = describe(path);
  const Handle properties = makeProperties(H5P_DATASET_CREATE, what);
  const Shape chunk = chunkOf(rows_per_chunk, row_shape);
  check(H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data()),
        "Chunking " + what);
  if (shared) {
    check(H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY), "Allocating " + what);
  }
  check(H5Pset_shuffle(properties.get()), "Shuffling " + what);
  check(H5Pset_deflate(properties.get(), compression_level), "Compressing " + what);
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
  const double gap = std::numeric_limits<double>::quiet_NaN();
  const std::int64_t integer_gap = -1;
  const bool is_real = type == Type::float32 || type == Type::float64;
  check(is_real ? H5Pset_fill_value(properties.get(), H5T_NATIVE_DOUBLE, &gap)
                : H5Pset_fill_value(properties.get(), H5T_NATIVE_INT64, &integer_gap),
        "Filling " + what);
  hsize_t first = 0;
  for (auto const& part : parts) {
    if (part.num_rows == 0) {
      continue; // a selection of nothing is refused
    }
    const Shape part_shape = withRows(part.num_rows, row_shape);
    const Handle source = makeSpace(part_shape, part_shape, what);
    selectRows(space, shape, first, part.num_rows, what);
    check(
      H5Pset_virtual(properties.get(), space.get(), part.file.c_str(), path.c_str(), source.get()),
      "Mapping " + part.file + " into " + what);
    first += part.num_rows;
  }
  H5Sselect_all(space.get());
  return createWith(path, native(type), space, properties);
}
} // namespace asperity::h5
