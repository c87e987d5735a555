#include "base/hdf5/Group.hpp"
#include "base/hdf5/detail/Calls.hpp"

#include <algorithm>
#include <limits>

// Datasets of rows: extendable ones, and virtual ones that join them.
namespace asperity::h5
{
namespace
{
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

// What is read where a part is missing.
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

// Selects the rows of the virtual dataset from `first` on that are those of the part.
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
} // namespace

Dataset Group::createExtendable(std::string const& path, Type type, Shape const& row_shape,
                                hsize_t rows_per_chunk, bool shared)
{
  const int compression_level = 4;
  const std::string what = describe(path);
  const Handle properties = makeProperties(H5P_DATASET_CREATE, what);
  const Shape chunk = chunkOf(rows_per_chunk, row_shape);
  checked("Chunking " + what, [&] {
    return H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
  });
  if (shared) {
    checked("Allocating " + what,
            [&] { return H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY); });
  }
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
    if (part.num_rows > 0) { // a selection of nothing is refused
      mapRows(properties, space, shape, first, part, path, what);
      first += part.num_rows;
    }
  }
  checked("Selecting all of " + what, [&] { return H5Sselect_all(space.get()); });
  return createWith(path, native(type), space, properties);
}
} // namespace asperity::h5
