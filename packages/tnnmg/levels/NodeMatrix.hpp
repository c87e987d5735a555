#pragma once

#include "base/Types.hpp"
#include "tnnmg/Halo.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace asperity::tnnmg::detail
{
// Which nodes a matrix couples, on this rank. A node of the rows has row_size successive rows, a
// node of the columns column_size successive columns, and the global id of a row is that of its
// node times row_size plus the component.
struct NodeGraph
{
  int row_size = 0, column_size = 0;
  int num_rows = 0;         // owned nodes
  int num_owned = 0;        // nodes of the columns that this rank owns; its ghosts follow
  std::vector<int> first;   // (num_rows + 1) where the couplings of a row begin
  std::vector<int> columns; // (num couplings) local nodes, ascending within a row
  RCP<const Map> row_map, domain_map;
  RCP<const Map> column_map;        // of owned and ghost columns; null on one rank
  std::shared_ptr<const Halo> halo; // of the columns; null on one rank

  int numCouplings() const { return first.back(); }
  int blockSize() const { return row_size * column_size; }
  // The coupling of a row with a column, or -1.
  int find(int row, int column) const;
};

// The union of the couplings of matrices with the same row and domain map. Collective.
NodeGraph makeNodeGraph(std::vector<RCP<const CrsMatrix>> const& matrices, int row_size,
                        int column_size);

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

// Blocks in the order of the couplings, row by row, in single precision: the matrices of a
// preconditioner, whose cost is the memory that they read. A product with single blocks reads a
// third of what a sparse matrix of scalars needs.
using NodeBlocks = PaddedVector;

// The entries of a matrix at the couplings of a graph that includes its own; zero elsewhere.
NodeBlocks blocksOf(NodeGraph const& graph, CrsMatrix const& matrix);

// Local vectors, node after node. Vectors on columns have the ghosts at their end.
using NodeVector = PaddedVector;

// Sends owned values to the ghosts of other ranks. Nothing to do on one rank.
class GhostExchange
{
public:
  explicit GhostExchange(NodeGraph const& graph);
  // x(columns): owned values to ghosts.
  void share(NodeVector& x) const;
  // x(columns): adds what ghosts have to the values of their owners.
  void gather(NodeVector& x) const;

private:
  std::shared_ptr<const Halo> halo_;
  int num_owned_;
  mutable std::vector<float> sent_, received_;
};

// y += A x, and y(columns) = A^T x.
void multiplyAdd(NodeGraph const& graph, NodeBlocks const& A, NodeVector const& x, NodeVector& y);
void multiplyTransposed(NodeGraph const& graph, NodeBlocks const& A, NodeVector const& x,
                        NodeVector& y);
} // namespace asperity::tnnmg::detail
