#include "hdf5/File.hpp"

#include "base/program/MpiScope.hpp"
#include "hdf5/detail/Calls.hpp"

#include <algorithm>
#include <array>
#include <fstream>

namespace asperity::h5
{
File File::create(std::filesystem::path const& path, Layout layout)
{
  const Handle access = makeProperties(H5P_FILE_ACCESS, path.string());
  // The default is different in HDF5 2.
  const auto oldest = layout == Layout::sealed ? H5F_LIBVER_V18 : H5F_LIBVER_EARLIEST;
  checked("Choosing the layout of " + path.string(),
          [&] { return H5Pset_libver_bounds(access.get(), oldest, H5F_LIBVER_LATEST); });
  try {
    return File(
      opened("Creating " + path.string(), H5Fclose,
             [&] { return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()); }),
      path.string());
  } catch (Error const&) {
    noteUnclosedHdf5(); // if the disk is full, HDF5 keeps a part of the file open
    throw;
  }
}

File File::openWith(std::filesystem::path const& path, unsigned mode, Handle const& access)
{
  return File(opened("Opening " + path.string(), H5Fclose,
                     [&] { return H5Fopen(path.c_str(), mode, access.get()); }),
              path.string());
}

File File::open(std::filesystem::path const& path)
{
  return openWith(path, H5F_ACC_RDONLY, makeProperties(H5P_FILE_ACCESS, path.string()));
}

bool File::isSealed(std::filesystem::path const& path)
{
  constexpr char signature[] = "\x89HDF\r\n\x1a\n";
  constexpr std::size_t length = sizeof(signature) - 1;
  constexpr int oldest_with_checksums = 2; // version of HDF5's first structure
  std::array<char, length + 1> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return std::equal(signature, signature + length, start.begin()) &&
         start[length] >= oldest_with_checksums;
}

File File::openForWriting(std::filesystem::path const& path)
{
  return openWith(path, H5F_ACC_RDWR, makeProperties(H5P_FILE_ACCESS, path.string()));
}

void File::close() { handle_.close("Closing " + what_); }
} // namespace asperity::h5
