#pragma once

#include "base/hdf5/Group.hpp"

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
  sealed // HDF5's own structures have checksums too; texts, for that, need a fixed length
};

// A rank that cannot write to a file that several ranks write (openShared) prints a message, calls
// this with it, and ends the program with status 5 at once: HDF5 would leave the other ranks
// waiting. So what comes back from such a write has been written by all, and need not be agreed on.
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

  // For writing to what exists, or for reading, by all ranks of the communicator: objects may be
  // opened, and parts of datasets written or read, by all at once. One for writing has to be
  // closed by close(), which is collective; if something is thrown before, it stays open, as no
  // other ranks could be waited for. Collective.
  static File openShared(std::filesystem::path const& path, MPI_Comm comm);
  static File openSharedForReading(std::filesystem::path const& path, MPI_Comm comm);

  void flush();
  void close(); // Error if what is buffered cannot be written

private:
  File(Handle handle, std::string what) : Group(std::move(handle), std::move(what)) {}
  static File openWith(std::filesystem::path const& path, unsigned mode, Handle const& access);

  MPI_File shared_ = MPI_FILE_NULL; // if several ranks write it
};
} // namespace asperity::h5
