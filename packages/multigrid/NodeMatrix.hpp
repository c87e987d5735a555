#pragma once

#include "multigrid/Chunks.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace asperity::multigrid
{
// Zeros behind the last number, so that four lanes may be loaded from any place.
template <class T>
struct PaddingAllocator
{
  using value_type = T;
  static constexpr std::size_t padding = 4;

  PaddingAllocator() = default;
  template <class Other>
  PaddingAllocator(PaddingAllocator<Other> const&) noexcept
  {
  }
  T* allocate(std::size_t count)
  {
    T* memory = std::allocator<T>().allocate(count + padding);
    std::fill_n(memory + count, padding, T(0));
    return memory;
  }
  void deallocate(T* memory, std::size_t count) noexcept
  {
    std::allocator<T>().deallocate(memory, count + padding);
  }
  friend bool operator==(PaddingAllocator, PaddingAllocator) { return true; }
  friend bool operator!=(PaddingAllocator, PaddingAllocator) { return false; }
};
using PaddedVector = std::vector<float, PaddingAllocator<float>>;

// Local vectors, node after node. Vectors on columns have the ghosts at their end.
using NodeVector = PaddedVector;

// Exchanges the values that other ranks have copies of, for vectors on the columns of a matrix.
// Collective.
class Ghosts
{
public:
  virtual ~Ghosts() = default;
  virtual void share(NodeVector& x) const = 0;  // copies owned values to ghosts
  virtual void gather(NodeVector& x) const = 0; // adds what ghosts have to their owners' values
};

// Which nodes a matrix couples, on this rank. A node of the rows has row_size successive rows, a
// node of the columns column_size successive columns.
struct NodeGraph
{
  int row_size = 0, column_size = 0;
  int num_rows = 0;         // owned nodes
  int num_owned = 0;        // nodes of the columns that this rank owns; its ghosts follow
  int num_columns = 0;      // nodes of the columns with ghosts
  std::vector<int> first;   // (num_rows + 1) where the couplings of a row begin
  std::vector<int> columns; // (num couplings) local nodes, ascending within a row
  std::shared_ptr<const Ghosts> ghosts; // of the columns; null on one rank

  int numCouplings() const { return first.back(); }
  int blockSize() const { return row_size * column_size; }
  // The number of scalar rows, and of scalar columns with ghosts.
  std::size_t rows() const { return static_cast<std::size_t>(num_rows) * row_size; }
  std::size_t columnsWithGhosts() const
  {
    return static_cast<std::size_t>(num_columns) * column_size;
  }
  // The coupling of a row with a column, or -1.
  int find(int row, int column) const;
  void share(NodeVector& x) const;
  void gather(NodeVector& x) const;
};

// Blocks in the order of the couplings, row by row, in single precision: the matrices of a
// preconditioner, whose cost is the memory that they read. A product with single blocks reads a
// third of what a sparse matrix of scalars needs.
using NodeBlocks = PaddedVector;

// y += A x, and y(columns) = A^T x. `parts` are results of chunks but the first, overwritten.
void multiplyAdd(NodeGraph const& graph, Chunks const& chunks, NodeBlocks const& A,
                 NodeVector const& x, NodeVector& y);
void multiplyTransposed(NodeGraph const& graph, Chunks const& chunks, NodeBlocks const& A,
                        NodeVector const& x, NodeVector& y, std::vector<NodeVector>& parts);
} // namespace asperity::multigrid
