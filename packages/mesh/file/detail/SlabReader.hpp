#pragma once

#include "hdf5/File.hpp"
#include "mesh/file/detail/PartitionFormat.hpp"

#include <functional>
#include <optional>

namespace asperity::mesh::detail
{
// Reads the arrays of a partitioned file, part by part, and compares their checksums. A rank that
// finds a problem continues, since other ranks would wait for it forever; problem() then describes
// the first problem, and the rows are not valid.
class SlabReader
{
public:
  // The file has to exist.
  SlabReader(std::string const& file_name, PartitionSummary const& summary);

  // "" if nothing is wrong.
  std::string const& problem() const { return problem_; }

  // Row is a number, or an array of as many numbers as the dataset has columns.
  template <class Row>
  std::vector<Row> read(std::string const& array, int part)
  {
    std::vector<Row> rows;
    const auto checksum = readRows(
      array, part, RowType<Row>::columns, [&](h5::Dataset const& values, h5::Part const& wanted) {
        rows.resize(wanted.count);
        values.readPart(reinterpret_cast<typename RowType<Row>::Number*>(rows.data()), wanted);
      });
    if (problem_.empty() && partChecksum(seed_, array, part, rows) != checksum) {
      note("part " + std::to_string(part) + " of '" + array +
           "' does not have the checksum that it was written with. The file is damaged, or put "
           "together from several files");
    }
    return rows;
  }

private:
  using Read = std::function<void(h5::Dataset const& values, h5::Part const& wanted)>;
  struct Slab
  {
    h5::Part rows;
    std::uint64_t checksum = 0;
  };

  template <class Row>
  struct RowType
  {
    static constexpr hsize_t columns = 0;
    using Number = Row;
  };
  template <class Component, std::size_t N>
  struct RowType<std::array<Component, N>>
  {
    static constexpr hsize_t columns = N;
    using Number = Component;
  };

  // Returns the checksum in the file.
  std::uint64_t readRows(std::string const& array, int part, hsize_t columns, Read const& read);
  std::optional<h5::Dataset> openValues(std::string const& path, hsize_t columns) const;
  Slab findSlab(std::string const& array, int part, hsize_t num_rows_of_all);
  void note(std::string const& problem);

  std::string where_;
  std::uint64_t seed_;
  std::string problem_;
  std::optional<h5::File> file_;
};
} // namespace asperity::mesh::detail
