#include "mesh/file/detail/SlabReader.hpp"

#include <mpi.h>

namespace asperity::mesh::detail
{
namespace
{
hid_t openFile(std::string const& file_name, MPI_Comm communicator)
{
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (communicator != MPI_COMM_NULL) {
    H5Pset_fapl_mpio(access, communicator, MPI_INFO_NULL);
  }
  return H5Fopen(file_name.c_str(), H5F_ACC_RDONLY, access);
}

hid_t transferProperties(MPI_Comm communicator)
{
  const hid_t transfer = H5Pcreate(H5P_DATASET_XFER);
  if (communicator != MPI_COMM_NULL) {
    H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  }
  return transfer;
}

// (n) without columns, (n, columns) with them.
bool hasColumns(hid_t space, hsize_t columns, hsize_t& num_rows)
{
  hsize_t sizes[2] = {0, 0};
  const int wanted = columns == 0 ? 1 : 2;
  if (H5Sget_simple_extent_ndims(space) != wanted ||
      H5Sget_simple_extent_dims(space, sizes, nullptr) != wanted) {
    return false;
  }
  num_rows = sizes[0];
  return columns == 0 || sizes[1] == columns;
}

// No rows are selected too: a rank takes part in a collective read though it has none.
bool selectRows(hid_t space, hsize_t first, hsize_t num_rows, hsize_t columns)
{
  const hsize_t start[2] = {first, 0}, count[2] = {num_rows, columns};
  return (num_rows == 0
            ? H5Sselect_none(space)
            : H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr)) >= 0;
}
} // namespace

SlabReader::SlabReader(std::string const& file_name, PartitionSummary const& summary,
                       MPI_Comm communicator)
    : where_("Mesh file '" + file_name + "'")
    , seed_(seedOf(summary))
    , file_(openFile(file_name, communicator), H5Fclose)
    , transfer_(transferProperties(communicator), H5Pclose)
{
  if (!file_.isValid()) {
    note("it cannot be opened by this rank");
  }
}

void SlabReader::note(std::string const& problem)
{
  if (problem_.empty()) {
    problem_ = where_ + ": " + problem + ". Partition the mesh again.";
  }
}

bool SlabReader::readEntries(std::string const& path, hid_t type, hsize_t first, hsize_t count,
                             void* values)
{
  const Hdf5Id dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose);
  const Hdf5Id memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  hsize_t size = 0;
  return dataset.isValid() && hasColumns(space, 0, size) && first + count <= size &&
         selectRows(space, first, count, 0) &&
         H5Dread(dataset, type, memory, space, H5P_DEFAULT, values) >= 0;
}

SlabReader::Slab SlabReader::findSlab(std::string const& array, int part, hsize_t num_rows_of_all)
{
  long long offsets[2] = {0, 0};
  Slab slab;
  const auto entry = static_cast<hsize_t>(part);
  const bool is_read =
    readEntries(array + "/offsets", H5T_NATIVE_LLONG, entry, 2, offsets) &&
    readEntries(array + "/checksums", H5T_NATIVE_UINT64, entry, 1, &slab.checksum);
  if (!is_read || offsets[0] < 0 || offsets[1] < offsets[0] ||
      static_cast<hsize_t>(offsets[1]) > num_rows_of_all) {
    note("'" + array + "' has no valid offsets and checksums for part " + std::to_string(part));
    return slab;
  }
  slab.first = static_cast<hsize_t>(offsets[0]);
  slab.num_rows = static_cast<hsize_t>(offsets[1] - offsets[0]);
  return slab;
}

std::uint64_t SlabReader::readRows(std::string const& array, int part, hsize_t columns, hid_t type,
                                   Destination const& destination)
{
  const std::string path = array + "/values";
  const Hdf5Id dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose);
  hsize_t num_rows_of_all = 0;
  if (!dataset.isValid() || !hasColumns(space, columns, num_rows_of_all)) {
    note("'" + path + "' is not there, is damaged or has another shape"); // on every rank alike
    return 0;
  }
  const Slab slab = findSlab(array, part, num_rows_of_all);
  if (num_rows_of_all == 0) { // nothing to take part in; HDF5 1.10 would fail
    return slab.checksum;
  }
  const hsize_t sizes[2] = {slab.num_rows, columns};
  const Hdf5Id memory(H5Screate_simple(columns == 0 ? 1 : 2, sizes, nullptr), H5Sclose);
  const bool is_read =
    selectRows(space, slab.first, slab.num_rows, columns) &&
    selectRows(memory, 0, slab.num_rows, columns) &&
    H5Dread(dataset, type, memory, space, transfer_, destination(slab.num_rows)) >= 0;
  if (!is_read) {
    note("'" + path + "' cannot be read");
  }
  return slab.checksum;
}
} // namespace asperity::mesh::detail
