#pragma once

#include "io/OutputDomain.hpp"

#include <vector>

namespace asperity::io
{
// Sends values of `owned` things, mine (num_rows, owned, num_components), each to the rank
// destinations(owned), where the item that arrives i-th takes the place numbers(i) of the block:
// (num_rows, block, num_components). T is double, int or long long. Collective.
template <class T>
std::vector<T> inBlock(std::vector<T> const& mine, std::size_t owned, std::size_t num_rows,
                       std::size_t num_components, std::vector<int> const& destinations,
                       std::vector<std::size_t> const& numbers, Communicator const& comm);

// Distributes nodes by number, in one block of equal length for each rank. Files have the same
// order, so every rank has one contiguous part.
class NodeBlocks
{
public:
  // node_numbers: of this rank's nodes; those of all ranks together are 0 <= number < num_global.
  // The communicator must outlive this. Collective.
  NodeBlocks(std::vector<GlobalOrdinal> const& node_numbers, GlobalOrdinal num_global,
             Communicator const& comm);
  explicit NodeBlocks(OutputDomain const& domain)
      : NodeBlocks(domain.node_numbers, domain.num_global_nodes, *domain.comm)
  {
  }

  // This rank's nodes are first() <= number < first() + count(); count() may be 0.
  GlobalOrdinal first() const { return begin(comm_.getRank()); }
  GlobalOrdinal count() const { return begin(comm_.getRank() + 1) - first(); }
  GlobalOrdinal total() const { return total_; } // of all ranks
  std::size_t numOwned() const { return destinations_.size(); }
  int rankOf(GlobalOrdinal number) const;

  // Sends nodal values to these blocks. mine: (num_rows, num_owned, num_components) in the order of
  // node_numbers; the result is (num_rows, count(), num_components) by number. T is double, int
  // or long long. Collective.
  template <class T>
  std::vector<T> operator()(std::vector<T> const& mine, std::size_t num_rows,
                            std::size_t num_components) const;

  // The other way: from block (count(), num_components) to (num_owned, num_components). Collective.
  template <class T>
  std::vector<T> back(std::vector<T> const& block, std::size_t num_components) const;

private:
  GlobalOrdinal begin(int rank) const;

  Communicator const& comm_;
  GlobalOrdinal total_;
  std::vector<int> destinations_;    // (num_owned)
  std::vector<std::size_t> numbers_; // (count()) within the block, in the order of arrival
  std::vector<int> owners_;          // (count()) the ranks from which they arrive
};
} // namespace asperity::io
