#pragma once

#include <hdf5.h>
#include <mpi.h>

#include <string>

// For the sources of this folder alone: what happens when a rank cannot write to a file that all
// ranks write. HDF5 tells it to that rank, and sometimes only after it has waited for the others,
// which wait for it. So no error of such a write reaches HDF5: MPI's own functions for writing are
// replaced (by MPI's profiling interface) by ones that look at what was written, and end the
// program, as whenSharingFails says. MPI's handlers of errors are not enough: Open MPI 4.1 does not
// call them where fewer bytes were written than asked for.
namespace asperity::h5
{
// From here to `endSharing` writes to this file, opened with MPI's driver, are looked at.
MPI_File beginSharing(hid_t file, std::string const& path);
void endSharing(MPI_File file);
} // namespace asperity::h5
