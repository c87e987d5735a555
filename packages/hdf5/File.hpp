#pragma once

#include "hdf5/Group.hpp"

#include <filesystem>
#include <string>
#include <utility>

// HDF5 with owned handles and exceptions: the only folder that calls HDF5. A file is written by one
// rank; many may read it, each for itself.
namespace asperity::h5
{
enum class Layout
{
  plain, // that of the oldest HDF5
  sealed // HDF5's own structures have checksums, too; so have texts of fixed length
};

class File : public Group
{
public:
  using Group::create;

  // Replaces a file of that name.
  static File create(std::filesystem::path const& path, Layout layout = Layout::plain);
  static File open(std::filesystem::path const& path); // for reading

  // Whether a file begins as those of Layout::sealed do. HDF5 itself may crash on a damaged file
  // whose structures have no checksums.
  static bool isSealed(std::filesystem::path const& path);

  // An existing file, for reading and for writing to its objects.
  static File openForWriting(std::filesystem::path const& path);

  void close(); // Error if what is buffered cannot be written

private:
  File(Handle handle, std::string what) : Group(std::move(handle), std::move(what)) {}
  static File openWith(std::filesystem::path const& path, unsigned mode, Handle const& access);
};
} // namespace asperity::h5
