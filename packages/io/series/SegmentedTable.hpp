#pragma once

#include "base/Archive.hpp"
#include "base/Types.hpp"
#include "hdf5/File.hpp"
#include "io/parallel/ElementBlocks.hpp"
#include "io/parallel/NodeBlocks.hpp"
#include "io/series/GeometryFile.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity::io
{
// "segments/fault_000012.h5", relative to the folder of the index.
std::string segmentName(std::string const& name, std::size_t segment);

// Writes the unit and the meaning of `dataset` into its attributes.
void describe(h5::Dataset dataset, std::string const& unit, std::string const& description);

// Rows of a few columns in closed segments DIR/segments/<name>_<nnnnnn>.h5, tied together by the
// virtual datasets of the index DIR/<name>.h5. A closed segment stays complete whatever happens; an
// open one may be lost. Every rank holds its part of the columns of nodes and elements, rank 0 all
// other columns; rank 0 writes, one rank's block after the other. No file is open between two
// calls. What rank 0 cannot write is an error on every rank. All functions are collective.
class SegmentedTable
{
public:
  struct Column
  {
    std::string path; // of the dataset, "fields/slip"
    std::string unit, description;
    h5::Type type = h5::Type::float64;
    h5::Shape row_shape; // of the value in a row; {} is a number
    // The first dimension of a row: nodes or elements of the domain, of which each rank has a part,
    // or neither (`run`).
    enum class Support
    {
      run,
      nodes,
      elements
    } support = Support::run;
    std::string components = {}; // "xx xy yy", an attribute; "" if they have no names
  };
  struct Options
  {
    std::filesystem::path directory;
    std::string name;
    std::vector<Column> columns;
    std::size_t rows_per_write = 64;
    // The domain of the columns of nodes and elements, or null if there are none. The index links
    // to its geometry as the group `geometry`.
    OutputDomain const* nodes = nullptr;
    // Adds to the index everything that does not grow, such as attributes. Called on rank 0.
    std::function<void(h5::File&)> describe_index;
    // A number for each node, (num_owned), in a dataset that each index has.
    struct NodalNumber
    {
      std::string path, unit, description;
      std::vector<double> const* values;
    };
    std::vector<NodalNumber> nodal_numbers;
  };

  SegmentedTable(Options options, RCP<const Communicator> comm);

  // Adds rows. `values` has one vector for each column: (num_rows, num_owned, components) on every
  // rank for a column of nodes or elements, (num_rows, row shape) on rank 0 for any other; there
  // the values of other ranks are ignored.
  void append(std::size_t num_rows, std::vector<std::vector<double>> const& values);

  // Completes the segment `index`, one more than that of the last call, and writes the index anew.
  // A segment without rows has no file.
  void closeSegment(int index);

  // Save and restore everything up to the last closed segment. restore removes later segments; it
  // throws InputError if an earlier one is missing.
  void save(Archive& archive) const;
  void restore(Archive const& archive);

  // The number of rows of each closed segment.
  std::vector<std::int64_t> const& rowsOfSegment() const { return rows_of_segment_; }

  // May be called once a segment has been closed, or after restore.
  detail::GeometryFile const& geometry() const { return *geometry_; }

private:
  void openSegment() const;
  void writeRows();
  void writeColumn(std::optional<h5::File>& segment, std::size_t i);
  template <class Blocks>
  void writeBlocks(std::optional<h5::Dataset>& dataset, std::size_t i, Blocks const& blocks) const;
  void writeGeometry();
  void writeIndex() const;
  h5::File createIndex() const;
  void removeLaterSegments() const;
  std::filesystem::path indexPath() const;
  std::filesystem::path segmentPath(std::size_t segment) const;

  Options options_;
  RCP<const Communicator> comm_;
  std::optional<NodeBlocks> blocks_;             // of the nodes, if there is a domain
  std::optional<ElementBlocks> elements_;        // if there are columns of elements
  std::optional<detail::GeometryFile> geometry_; // once written
  std::vector<std::int64_t> rows_of_segment_;    // closed ones
  std::int64_t rows_in_open_segment_ = 0;        // written or waiting
  std::size_t rows_waiting_ = 0;
  std::vector<std::vector<double>> waiting_; // by column
};
} // namespace asperity::io
