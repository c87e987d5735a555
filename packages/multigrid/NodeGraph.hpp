#pragma once

#include "multigrid/Arrays.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace asperity::multigrid
{
// The sizes of a graph. A node of the rows has row_size successive rows, a node of the columns
// column_size successive columns.
struct GraphSizes
{
  int row_size = 0, column_size = 0;
  int num_rows = 0;    // owned nodes
  int num_owned = 0;   // nodes of the columns that this rank owns; its ghosts follow
  int num_columns = 0; // nodes of the columns with ghosts

  int blockSize() const { return row_size * column_size; }
  // The number of scalar rows, and of scalar columns with ghosts.
  std::size_t rows() const { return static_cast<std::size_t>(num_rows) * row_size; }
  std::size_t columnsWithGhosts() const
  {
    return static_cast<std::size_t>(num_columns) * column_size;
  }
};

// How ranks exchange the values of columns that others have copies of. Both take vectors on the
// columns with ghosts, are null on one rank, and are collective.
struct ColumnExchange
{
  std::function<void(NodeVector const& x)> share;  // copies owned values to ghosts
  std::function<void(NodeVector const& x)> gather; // adds what ghosts have to their owners' values
  // The same where owned scalar columns have got these numbers. Not collective.
  std::function<ColumnExchange(std::vector<int> const& number)> renumbered;
};

// Which nodes a matrix couples, on this rank; where it is made.
struct HostGraph : GraphSizes
{
  std::vector<int> first;   // (num_rows + 1) where the couplings of a row begin
  std::vector<int> columns; // (num couplings) local nodes, ascending within a row
  ColumnExchange ghosts;    // of the columns

  int numCouplings() const { return first.back(); }
  // The coupling of a row with a column, or -1.
  int find(int row, int column) const;
};

// The same where kernels run.
struct DeviceGraph : GraphSizes
{
  IndexView columns;     // (num couplings)
  ColumnExchange ghosts; // of the columns

  DeviceGraph() = default;
  DeviceGraph(HostGraph const& host, std::vector<int> const& columns_in_order);

  int numCouplings() const { return columns.extent_int(0); }
  // Send owned values to ghosts, and add those of ghosts to their owners'; x: on the columns.
  // Collective.
  void share(NodeVector const& x) const;
  void gather(NodeVector const& x) const;
};

// With the couplings row by row.
struct NodeGraph : DeviceGraph
{
  IndexView first;

  NodeGraph() = default;
  explicit NodeGraph(HostGraph const& host);
};

// The couplings of a square matrix, as sweeps read it: first all couplings with earlier nodes, row
// by row, then those of nodes with themselves, then those with later nodes and ghosts. Half a sweep
// needs one part of these, and reads it from end to end; if the halves of a row lay side by side, a
// processor would fetch whole rows, twice.
struct MatrixGraph : DeviceGraph
{
  IndexView lower;    // (num_rows + 1) where a row's couplings with earlier nodes begin
  IndexView upper;    // (num_rows + 1) where those with later nodes and ghosts begin
  IndexView diagonal; // (num_rows) the coupling with itself, or -1

  MatrixGraph() = default;
  explicit MatrixGraph(HostGraph const& host);

  // (num couplings): the place of each of the host's couplings.
  static std::vector<int> order(HostGraph const& host);

  // Calls work(row, column, coupling) for all couplings. The graph is copied to the host.
  template <class Work>
  void forEachCoupling(Work const& work) const
  {
    const auto lower_ends = toHost(lower), upper_ends = toHost(upper), own = toHost(diagonal);
    const auto column = toHost(columns);
    for (int row = 0; row < num_rows; ++row) {
      for (int k = lower_ends(row); k < lower_ends(row + 1); ++k) {
        work(row, column(k), k);
      }
      if (own(row) >= 0) {
        work(row, row, own(row));
      }
      for (int k = upper_ends(row); k < upper_ends(row + 1); ++k) {
        work(row, column(k), k);
      }
    }
  }
};
} // namespace asperity::multigrid
