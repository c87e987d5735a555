#include "hdf5/Dataset.hpp"

#include "hdf5/detail/Calls.hpp"
#include "hdf5/detail/Texts.hpp"

#include <functional>
#include <numeric>

namespace asperity::h5
{
Handle Dataset::space() const
{
  return opened("Asking the shape of " + what_, H5Sclose,
                [&] { return H5Dget_space(handle_.get()); });
}

Handle Dataset::fileType() const
{
  return opened("Asking the type of " + what_, H5Tclose,
                [&] { return H5Dget_type(handle_.get()); });
}

ValueClass Dataset::valueClass() const { return valueClassOf(fileType().get(), what_); }

Type Dataset::type() const
{
  const Handle type = fileType();
  const std::size_t size = H5Tget_size(type.get());
  if (valueClassOf(type.get(), what_) == ValueClass::real) {
    return size <= 4 ? Type::float32 : Type::float64;
  }
  if (size <= 4) {
    return size == 1 ? Type::int8 : Type::int32;
  }
  return H5Tget_sign(type.get()) == H5T_SGN_NONE ? Type::uint64 : Type::int64;
}

Shape Dataset::shape() const { return shapeOf(space(), what_); }

std::size_t Dataset::numValues() const
{
  requireStorage();
  const Shape all = shape();
  return std::accumulate(all.begin(), all.end(), std::size_t(1), std::multiplies<>());
}

void Dataset::requireStorage() const
{
  const Handle properties = opened("Asking the layout of " + what_, H5Pclose,
                                   [&] { return H5Dget_create_plist(handle_.get()); });
  const H5D_layout_t layout = H5Pget_layout(properties.get());
  if (layout == H5D_VIRTUAL || H5Pget_external_count(properties.get()) > 0) {
    return; // the values are in other files
  }
  const Handle file =
    opened("Asking the file of " + what_, H5Fclose, [&] { return H5Iget_file_id(handle_.get()); });
  hsize_t file_size = 0;
  checked("Asking the size of " + what_, [&] { return H5Fget_filesize(file.get(), &file_size); });
  // Deflate expands one byte to at most 1032 bytes.
  double largest_size = (layout == H5D_CHUNKED ? 1032. : 1.) * static_cast<double>(file_size);
  largest_size /= static_cast<double>(H5Tget_size(fileType().get()));
  double size = 1;
  for (const hsize_t extent : shape()) {
    size *= static_cast<double>(extent);
  }
  if (size > largest_size) {
    throw Error(what_ + " has a shape for which the file is too small: it is damaged.");
  }
}

void Dataset::writeAll(Type type, void const* values)
{
  checked("Writing " + what_, [&] {
    return H5Dwrite(handle_.get(), native(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
  });
}

void Dataset::readAll(Type type, void* values) const
{
  checked("Reading " + what_, [&] {
    return H5Dread(handle_.get(), native(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
  });
}

std::vector<std::string> Dataset::readTexts() const
{
  const Handle type = fileType();
  if (valueClassOf(type.get(), what_) != ValueClass::text) {
    throw Error("The dataset " + what_ + " does not consist of texts.");
  }
  return h5::readTexts(type, numValues(), what_, [&](void* values) {
    checked("Reading " + what_, [&] {
      return H5Dread(handle_.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    });
  });
}

void Dataset::extend(hsize_t num_rows)
{
  Shape extended = shape();
  extended[0] += num_rows;
  checked("Extending " + what_, [&] { return H5Dset_extent(handle_.get(), extended.data()); });
}
} // namespace asperity::h5
