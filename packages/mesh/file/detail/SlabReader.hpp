#pragma once

#include "mesh/file/detail/Hdf5Id.hpp"
#include "mesh/file/detail/PartitionFormat.hpp"

#include <functional>

namespace asperity::mesh::detail
{
// Reads the arrays of a partitioned file, part by part, and compares their checksums. Of the ranks
// of a communicator each may read a part of its own: all of them call the same functions for the
// same arrays. A rank on which something is wrong goes on, or others would wait for it in vain;
// what is wrong first is in problem(), and then its rows are worth nothing.
class SlabReader
{
public:
  // The file is known to exist. MPI_COMM_NULL stands for a process by itself.
  SlabReader(std::string const& file_name, PartitionSummary const& summary, MPI_Comm communicator);

  // "" if nothing is wrong.
  std::string const& problem() const { return problem_; }

  // Rows are numbers, or arrays of as many numbers as the dataset has columns.
  template <class Row>
  std::vector<Row> read(std::string const& array, int part)
  {
    std::vector<Row> rows;
    const auto checksum = readRows(array, part, RowType<Row>::columns, RowType<Row>::native(),
                                   [&](std::size_t num_rows) {
                                     rows.resize(num_rows);
                                     return static_cast<void*>(rows.data());
                                   });
    if (problem_.empty() && partChecksum(seed_, array, part, rows) != checksum) {
      note("part " + std::to_string(part) + " of '" + array +
           "' is not as it was written, by its checksum. The file is damaged, or put together from "
           "several ones");
    }
    return rows;
  }

private:
  using Destination = std::function<void*(std::size_t num_rows)>;
  struct Slab
  {
    hsize_t first = 0;
    hsize_t num_rows = 0;
    std::uint64_t checksum = 0;
  };

  template <class Row>
  struct RowType
  {
    static constexpr hsize_t columns = 0;
    static hid_t native() { return nativeType(Row()); }
  };
  template <class Number, std::size_t N>
  struct RowType<std::array<Number, N>>
  {
    static constexpr hsize_t columns = N;
    static hid_t native() { return nativeType(Number()); }
  };

  // Returns the checksum that the file has.
  std::uint64_t readRows(std::string const& array, int part, hsize_t columns, hid_t type,
                         Destination const& destination);
  Slab findSlab(std::string const& array, int part, hsize_t num_rows_of_all);
  bool readEntries(std::string const& path, hid_t type, hsize_t first, hsize_t count, void* values);
  void note(std::string const& problem);

  Hdf5Silence silence_;
  std::string where_;
  std::uint64_t seed_;
  std::string problem_;
  Hdf5Id file_;
  Hdf5Id transfer_; // collective among ranks
};
} // namespace asperity::mesh::detail
