#pragma once

#include "io/parallel/NodeBlocks.hpp"

#include <vector>

namespace asperity::io
{
// Distributes the elements of a domain in the order of files, one contiguous block for each rank:
// by their sorted node numbers, but elements that reach across a period come last, on the last
// rank. The order is the same on any number of ranks.
class ElementBlocks
{
public:
  ElementBlocks(OutputDomain const& domain, NodeBlocks const& blocks); // collective

  GlobalOrdinal first() const { return first_; }
  GlobalOrdinal count() const { return static_cast<GlobalOrdinal>(numbers_.size()); }
  GlobalOrdinal total() const { return total_; } // of all ranks
  GlobalOrdinal numWhole() const
  {
    return num_whole_;
  } // of all ranks, without those across a period

  // The nodes of this block's elements by number, (count(), nodes_per_element).
  std::vector<GlobalOrdinal> const& nodes() const { return nodes_; }

  // Sends values of elements to these blocks. mine: (num_rows, num_owned_elements, num_components)
  // in the order of the domain; the result is (num_rows, count(), num_components). Collective.
  std::vector<double> operator()(std::vector<double> const& mine, std::size_t num_rows,
                                 std::size_t num_components) const;

private:
  OutputDomain const& domain_;
  std::vector<int> destinations_;    // (num_owned_elements)
  std::vector<std::size_t> numbers_; // (count()) within the block, in the order of arrival
  std::vector<GlobalOrdinal> nodes_;
  GlobalOrdinal first_ = 0, total_ = 0, num_whole_ = 0;
};
} // namespace asperity::io
