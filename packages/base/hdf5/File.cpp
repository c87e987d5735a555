#include "base/hdf5/File.hpp"

#include "base/hdf5/detail/Calls.hpp"
#include "base/hdf5/detail/SharedWrites.hpp"

namespace asperity::h5
{
namespace
{
int numRanks(MPI_Comm comm)
{
  int num_ranks = 1;
  if (comm != MPI_COMM_SELF) { // which a program without MPI names, too
    MPI_Comm_size(comm, &num_ranks);
  }
  return num_ranks;
}

Handle sharedAccess(std::filesystem::path const& path, MPI_Comm comm)
{
  Handle access = makeProperties(H5P_FILE_ACCESS, path.string());
  if (numRanks(comm) > 1) { // a single rank needs no MPI-IO, which some file systems lack
    checked("Sharing " + path.string(),
            [&] { return H5Pset_fapl_mpio(access.get(), comm, MPI_INFO_NULL); });
  }
  return access;
}
} // namespace

File File::create(std::filesystem::path const& path, Layout layout)
{
  const Handle access = makeProperties(H5P_FILE_ACCESS, path.string());
  if (layout == Layout::sealed) {
    checked("Sealing " + path.string(),
            [&] { return H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_LATEST); });
  }
  try {
    return File(
      opened("Creating " + path.string(), H5Fclose,
             [&] { return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()); }),
      path.string());
  } catch (Error const&) {
    noteUnclosed(); // where the first bytes find no space, a part of it stays open
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

File File::openShared(std::filesystem::path const& path, MPI_Comm comm)
{
  const Handle access = sharedAccess(path, comm);
  if (numRanks(comm) == 1) {
    return openWith(path, H5F_ACC_RDWR, access);
  }
  File file = openWith(path, H5F_ACC_RDWR, access);
  file.handle_.closeOnlyOnDemand();
  file.shared_ = beginSharing(file.handle_.get(), path.string());
  return file;
}

File File::openSharedForReading(std::filesystem::path const& path, MPI_Comm comm)
{
  return openWith(path, H5F_ACC_RDONLY, sharedAccess(path, comm));
}

void File::flush()
{
  checked("Writing " + what_, [&] { return H5Fflush(handle_.get(), H5F_SCOPE_LOCAL); });
}

void File::close()
{
  handle_.close("Closing " + what_);
  endSharing(shared_);
}
} // namespace asperity::h5
