#pragma once

#include "io/OutputDomain.hpp"

#include <vector>

namespace asperity::io
{
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
  std::vector<int> destinations_;      // (num_owned)
  std::vector<GlobalOrdinal> numbers_; // (count()) in the order in which they arrive
};
} // namespace asperity::io
