#pragma once

#include "io/OutputDomain.hpp"

#include <vector>

namespace asperity::io
{
// Sends values of `owned` things, mine (num_rows, owned, num_components), each to the rank
// destinations(owned), where the item that arrives i-th takes the place numbers(i) of the block:
// (num_rows, block, num_components). T is double or GlobalOrdinal. Collective.
template <class T>
std::vector<T> inBlock(std::vector<T> const& mine, std::size_t owned, std::size_t num_rows,
                       std::size_t num_components, std::vector<int> const& destinations,
                       std::vector<std::size_t> const& numbers, Communicator const& comm);

// Distributes the nodes of a domain by number, in one block of equal length for each rank. Files
// have the same order, so every rank writes one contiguous part.
class NodeBlocks
{
public:
  explicit NodeBlocks(OutputDomain const& domain); // collective

  // This rank's nodes are first() <= number < first() + count(); count() may be 0.
  GlobalOrdinal first() const { return begin(domain_.comm->getRank()); }
  GlobalOrdinal count() const { return begin(domain_.comm->getRank() + 1) - first(); }
  int rankOf(GlobalOrdinal number) const;

  // Sends nodal values to these blocks. mine: (num_rows, num_owned, num_components) in the order of
  // the domain; the result is (num_rows, count(), num_components) by number. T is double or
  // GlobalOrdinal. Collective.
  template <class T>
  std::vector<T> operator()(std::vector<T> const& mine, std::size_t num_rows,
                            std::size_t num_components) const;

private:
  GlobalOrdinal begin(int rank) const;

  OutputDomain const& domain_;
  std::vector<int> destinations_;    // (num_owned)
  std::vector<std::size_t> numbers_; // (count()) within the block, in the order of arrival
};
} // namespace asperity::io
