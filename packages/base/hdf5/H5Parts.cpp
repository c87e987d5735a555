#include "base/hdf5/H5.hpp"

#include "base/hdf5/detail/H5Calls.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

// Datasets that several ranks write together.
namespace asperity::h5
{
namespace
{
// Whether the file of the object was opened by several ranks, which write together.
bool isShared(Handle const& object, std::string const& what)
{
  const Handle file(H5Iget_file_id(object.get()), H5Fclose, "Asking the file of " + what);
  const Handle access(H5Fget_access_plist(file.get()), H5Pclose, "Asking the access to " + what);
  return H5Pget_driver(access.get()) == H5FD_MPIO;
}
} // namespace

void Dataset::writeSlab(void const* values, hid_t memory_type, Shape const& start,
                        Shape const& count)
{
  const Handle file_space(H5Dget_space(handle_.get()), H5Sclose, "Asking the shape of " + what_);
  const Handle memory_space = makeSpace(count, count, what_);
  if (std::find(count.begin(), count.end(), 0) != count.end()) {
    check(H5Sselect_none(file_space.get()), "Selecting nothing of " + what_);
    check(H5Sselect_none(memory_space.get()), "Selecting nothing of " + what_);
  } else {
    check(H5Sselect_hyperslab(file_space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                              nullptr),
          "Selecting a part of " + what_);
  }
  const Handle together = makeProperties(H5P_DATASET_XFER, what_);
  if (isShared(handle_, what_)) {
    check(H5Pset_dxpl_mpio(together.get(), H5FD_MPIO_COLLECTIVE), "Sharing " + what_);
  }
  check(H5Dwrite(handle_.get(), memory_type, memory_space.get(), file_space.get(), together.get(),
                 values),
        "Writing " + what_);
}

namespace
{
// Start and count of a part, whose numbers are those of the dimension `d`.
std::array<Shape, 2> slabOf(Shape count, std::size_t d, Part const& part)
{
  Shape start(count.size(), 0);
  if (d < count.size()) {
    start[d] = part.first;
    count[d] = part.count;
  } else if (part.count == 0) {
    count[0] = 0; // of rows that are single numbers
  }
  return {start, count};
}
} // namespace

void Dataset::writePart(double const* values, Part const& part)
{
  const auto [start, count] = slabOf(shape(), 0, part);
  writeSlab(values, H5T_NATIVE_DOUBLE, start, count);
}

void Dataset::writePart(std::int64_t const* values, Part const& part)
{
  const auto [start, count] = slabOf(shape(), 0, part);
  writeSlab(values, H5T_NATIVE_INT64, start, count);
}

void Dataset::appendPart(double const* values, hsize_t num_rows, Part const& part)
{
  Shape rows = extend(num_rows);
  const hsize_t first = rows[0] - num_rows;
  rows[0] = num_rows;
  auto [start, count] = slabOf(rows, 1, part);
  start[0] = first;
  const auto size = std::accumulate(count.begin(), count.end(), hsize_t(1), std::multiplies<>());
  // HDF5 writes together only what it need not convert.
  if (type() == Type::int64) {
    const std::vector<std::int64_t> converted(values, values + size);
    writeSlab(converted.data(), H5T_NATIVE_INT64, start, count);
  } else if (type() == Type::float32) {
    const std::vector<float> converted(values, values + size);
    writeSlab(converted.data(), H5T_NATIVE_FLOAT, start, count);
  } else {
    writeSlab(values, H5T_NATIVE_DOUBLE, start, count);
  }
}
} // namespace asperity::h5
