#include "base/hdf5/detail/SharedWrites.hpp"

#include "base/hdf5/File.hpp"
#include "base/hdf5/detail/Calls.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <thread>

namespace asperity::h5
{
namespace
{
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

// Several ranks may fail: the lowest of them ends the others while they wait.
[[noreturn]] void endProgram(std::string const& path, MPI_Count written, MPI_Count size)
{
  constexpr int exit_output = 5;
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::this_thread::sleep_for(std::chrono::milliseconds(500) * std::min(rank, 20));
  const std::string message = path + " cannot be written: of " + std::to_string(size) +
                              " bytes of rank " + std::to_string(rank) + " " +
                              std::to_string(written) + " were written. Is the disk full?";
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

// write(status), which is to write `count` of `type`.
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
} // namespace

void whenSharingFails(std::function<void(std::string const&)> tell) { teller() = std::move(tell); }

MPI_File beginSharing(hid_t file, std::string const& path)
{
  void* handle = nullptr;
  checked("Sharing " + path, [&] { return H5Fget_vfd_handle(file, H5P_DEFAULT, &handle); });
  const MPI_File mpi_file = *static_cast<MPI_File*>(handle);
  sharedFiles()[mpi_file] = path;
  return mpi_file;
}

void endSharing(MPI_File file) { sharedFiles().erase(file); }
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
