#include "base/hdf5/File.hpp"

#include "base/hdf5/detail/Calls.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

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

std::function<void(std::string const&)>& teller()
{
  static std::function<void(std::string const&)> tell;
  return tell;
}

// Whether all ranks hear of an error, so that each can throw: a file cannot be opened.
bool isOfOpening(int error)
{
  int kind = MPI_SUCCESS;
  MPI_Error_class(error, &kind);
  return kind == MPI_ERR_NO_SUCH_FILE || kind == MPI_ERR_ACCESS || kind == MPI_ERR_FILE_EXISTS ||
         kind == MPI_ERR_BAD_FILE || kind == MPI_ERR_READ_ONLY || kind == MPI_ERR_AMODE;
}

// Called by MPI. Several ranks may fail: the lowest of them ends the others while they wait.
void endOfSharing(MPI_File*, int* error, ...)
{
  if (isOfOpening(*error)) {
    return;
  }
  constexpr int exit_output = 5;
  int rank = 0, length = 0;
  char words[MPI_MAX_ERROR_STRING] = "";
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Error_string(*error, words, &length);
  std::this_thread::sleep_for(std::chrono::milliseconds(500) * std::min(rank, 20));
  const std::string message = "A file that all ranks write cannot be written by rank " +
                              std::to_string(rank) + " (MPI: " + words + "). Is the disk full?";
  std::cout.flush();
  std::cerr << "asperity: " + message + "\n" << std::flush;
  if (teller()) {
    teller()(message);
  }
  MPI_Abort(MPI_COMM_WORLD, exit_output);
  std::abort();
}

// As long as it lives, files are opened by MPI with that handler of errors.
class EndOfSharing
{
public:
  EndOfSharing()
  {
    MPI_File_get_errhandler(MPI_FILE_NULL, &before_);
    MPI_File_create_errhandler(endOfSharing, &here_);
    MPI_File_set_errhandler(MPI_FILE_NULL, here_);
  }
  ~EndOfSharing()
  {
    MPI_File_set_errhandler(MPI_FILE_NULL, before_);
    MPI_Errhandler_free(&here_); // files keep it
  }
  EndOfSharing(EndOfSharing const&) = delete;
  EndOfSharing& operator=(EndOfSharing const&) = delete;

private:
  MPI_Errhandler before_ = MPI_ERRHANDLER_NULL, here_ = MPI_ERRHANDLER_NULL;
};

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

void whenSharingFails(std::function<void(std::string const&)> tell) { teller() = std::move(tell); }

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
  const EndOfSharing handler;
  File file = openWith(path, H5F_ACC_RDWR, access);
  file.handle_.closeOnlyOnDemand();
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

void File::close() { handle_.close("Closing " + what_); }
} // namespace asperity::h5
