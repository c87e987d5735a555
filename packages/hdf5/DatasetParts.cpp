#include "hdf5/Dataset.hpp"
#include "hdf5/detail/Calls.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

// Parts of datasets.
namespace asperity::h5
{
namespace
{
struct Slab
{
  Shape start, count;
};

// The slab of a part, whose indices are those of the dimension `d`.
Slab slabOf(Shape count, std::size_t d, Part const& part)
{
  Shape start(count.size(), 0);
  if (d < count.size()) {
    start[d] = part.first;
    count[d] = part.count;
  } else if (part.count == 0) {
    count[0] = 0; // rows that are single numbers have no dimension d
  }
  return {start, count};
}

// Selects the slab in the file space and returns the selection in memory; both are empty if the
// slab is empty.
Handle select(Handle const& file_space, Slab const& slab, std::string const& what)
{
  Handle memory_space = makeSpace(slab.count, slab.count, what);
  if (std::find(slab.count.begin(), slab.count.end(), 0) != slab.count.end()) {
    checked("Selecting nothing of " + what, [&] { return H5Sselect_none(file_space.get()); });
    checked("Selecting nothing of " + what, [&] { return H5Sselect_none(memory_space.get()); });
  } else {
    checked("Selecting a part of " + what, [&] {
      return H5Sselect_hyperslab(file_space.get(), H5S_SELECT_SET, slab.start.data(), nullptr,
                                 slab.count.data(), nullptr);
    });
  }
  return memory_space;
}
} // namespace

void Dataset::writeSlab(Type type, void const* values, Shape const& start, Shape const& count)
{
  const Handle file_space = space();
  const Handle memory_space = select(file_space, {start, count}, what_);
  checked("Writing " + what_, [&] {
    return H5Dwrite(handle_.get(), native(type), memory_space.get(), file_space.get(), H5P_DEFAULT,
                    values);
  });
}

void Dataset::readPartOf(Type type, void* values, Part const& part) const
{
  const Handle file_space = space();
  const Shape all = shapeOf(file_space, what_);
  if (std::find(all.begin(), all.end(), 0) != all.end()) {
    return; // there is nothing to read, and HDF5 1.10 would fail
  }
  const Handle memory_space = select(file_space, slabOf(all, 0, part), what_);
  checked("Reading " + what_, [&] {
    return H5Dread(handle_.get(), native(type), memory_space.get(), file_space.get(), H5P_DEFAULT,
                   values);
  });
}

void Dataset::writePartOf(Type type, void const* values, Part const& part)
{
  const Slab slab = slabOf(shape(), 0, part);
  writeSlab(type, values, slab.start, slab.count);
}

void Dataset::writeRows(double const* values, hsize_t num_rows, Part const& part)
{
  Shape rows = shape();
  const hsize_t first = rows[0] - num_rows;
  rows[0] = num_rows;
  Slab slab = slabOf(rows, 1, part);
  slab.start[0] = first;
  const auto size =
    std::accumulate(slab.count.begin(), slab.count.end(), hsize_t(1), std::multiplies<>());
  const auto write = [&](Type type, void const* converted) {
    writeSlab(type, converted, slab.start, slab.count);
  };
  if (type() == Type::int64) {
    write(Type::int64, std::vector<std::int64_t>(values, values + size).data());
  } else if (type() == Type::float32) {
    write(Type::float32, std::vector<float>(values, values + size).data());
  } else {
    write(Type::float64, values);
  }
}
} // namespace asperity::h5
