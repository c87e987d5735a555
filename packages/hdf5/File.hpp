#pragma once

#include "hdf5/Group.hpp"

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

// HDF5 with owned handles and exceptions: the only folder that calls HDF5. A file is used by one
// rank, or by all of a communicator from openShared to close.
namespace asperity::h5
{
enum class Layout
{
  plain, // that of the oldest HDF5
  sealed // HDF5's own structures have checksums, too; so have texts of fixed length
};

// A rank that cannot write to a file that several ranks write (openShared) prints a message, passes
// it to `tell`, and ends the program with status 5 at once: HDF5 would leave the other ranks
// waiting. Hence when such a write returns, all ranks have written, and they need not agree on it.
void whenSharingFails(std::function<void(std::string const&)> tell);

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

  // Opens an existing file on all ranks of the communicator, for writing to existing objects or for
  // reading: all ranks open objects, and write or read parts of datasets, at once. A file opened
  // for writing must be closed by close(), which is collective. If an exception comes first, the
  // file stays open, because the other ranks may not arrive. Collective.
  static File openShared(std::filesystem::path const& path, MPI_Comm comm);
  static File openSharedForReading(std::filesystem::path const& path, MPI_Comm comm);

  void close(); // Error if what is buffered cannot be written

private:
  File(Handle handle, std::string what) : Group(std::move(handle), std::move(what)) {}
  static File openWith(std::filesystem::path const& path, unsigned mode, Handle const& access);

  MPI_File shared_ = MPI_FILE_NULL; // if several ranks write it
};
} // namespace asperity::h5
