#include "hdf5/File.hpp"

#include "base/WriteFailure.hpp"
#include "base/program/MpiScope.hpp"
#include "hdf5/detail/Calls.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <thread>

#include <dlfcn.h>

namespace asperity::h5
{
namespace
{
int numRanks(MPI_Comm comm)
{
  int num_ranks = 1;
  if (comm != MPI_COMM_SELF) { // a program without MPI uses it, too
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
// HDF5 reports a failed write only to the rank that failed, and sometimes only after this rank has
// waited for the others, which wait for it. Therefore no such error may reach HDF5: MPI's functions
// for writing are replaced (MPI's profiling interface) by functions that check how much was
// written. MPI's error handlers are not enough: Open MPI 4.1 does not call them if fewer bytes were
// written than requested.
std::function<void(std::string const&)>& teller()
{
  static std::function<void(std::string const&)> tell;
  return tell;
}

std::map<MPI_File, std::string>& sharedFiles()
{
  static std::map<MPI_File, std::string> paths;
  return paths;
}

// If several ranks fail, the lowest one aborts first, while the others wait.
[[noreturn]] void endProgram(std::string const& path, MPI_Count written, MPI_Count size)
{
  constexpr int exit_output = 5;
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::this_thread::sleep_for(std::chrono::milliseconds(500) * std::min(rank, 20));
  const std::string message = path + " cannot be written: rank " + std::to_string(rank) +
                              " wrote " + std::to_string(written) + " of " + std::to_string(size) +
                              " bytes. " + whyNotWritten(path);
  std::cout.flush();
  std::cerr << "asperity: " + message + "\n" << std::flush;
  if (teller()) {
    teller()(message);
  }
  MPI_Abort(MPI_COMM_WORLD, exit_output);
  std::abort();
}

MPI_Count bytesOf(int count, MPI_Datatype type)
{
  MPI_Count size = 0;
  MPI_Type_size_x(type, &size);
  return size * count;
}

// Calls write(status), which should write `count` values of `type`. Ends the program if a shared
// file has received fewer.
template <class Write>
int lookedAt(MPI_File file, int count, MPI_Datatype type, MPI_Status* status, Write const& write)
{
  MPI_Status own;
  MPI_Status* const told = status == MPI_STATUS_IGNORE ? &own : status;
  const int error = write(told);
  const auto found = sharedFiles().find(file);
  if (found == sharedFiles().end()) {
    return error;
  }
  MPI_Count written = 0;
  if (error == MPI_SUCCESS) {
    MPI_Get_elements_x(told, MPI_BYTE, &written);
  }
  if (written != bytesOf(count, type)) {
    endProgram(found->second, written, bytesOf(count, type));
  }
  return error;
}

void const* libraryOf(void* function)
{
  Dl_info info{};
  return ::dladdr(function, &info) != 0 ? info.dli_fbase : nullptr;
}

// The functions at the end of this file take the place of MPI's only in programs that load this
// library before MPI's.
void requireReplacement()
{
  if (libraryOf(reinterpret_cast<void*>(&MPI_File_write_at_all)) !=
      libraryOf(reinterpret_cast<void*>(&whenSharingFails))) {
    throw std::logic_error("The program is linked with MPI before Asperity's library hdf5, so that "
                           "a full disk would go unnoticed. Link Asperity's libraries first.");
  }
}

// From here on every write to the file, which was opened with MPI's driver, is checked.
MPI_File beginSharing(hid_t file, std::string const& path)
{
  requireReplacement();
  void* handle = nullptr;
  checked("Sharing " + path, [&] { return H5Fget_vfd_handle(file, H5P_DEFAULT, &handle); });
  MPI_File mpi_file = *static_cast<MPI_File*>(handle);
  sharedFiles()[mpi_file] = path;
  return mpi_file;
}
} // namespace

void whenSharingFails(std::function<void(std::string const&)> tell) { teller() = std::move(tell); }

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
    noteUnclosed(); // if the disk is full, HDF5 keeps a part of the file open
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

void File::close()
{
  handle_.close("Closing " + what_);
  sharedFiles().erase(shared_);
}
} // namespace asperity::h5

// HDF5 calls these instead of MPI's.
extern "C" {
int MPI_File_write_at(MPI_File file, MPI_Offset offset, void const* values, int count,
                      MPI_Datatype type, MPI_Status* status)
{
  return asperity::h5::lookedAt(file, count, type, status, [&](MPI_Status* told) {
    return PMPI_File_write_at(file, offset, values, count, type, told);
  });
}

int MPI_File_write_at_all(MPI_File file, MPI_Offset offset, void const* values, int count,
                          MPI_Datatype type, MPI_Status* status)
{
  return asperity::h5::lookedAt(file, count, type, status, [&](MPI_Status* told) {
    return PMPI_File_write_at_all(file, offset, values, count, type, told);
  });
}
}
