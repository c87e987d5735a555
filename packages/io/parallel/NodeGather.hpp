#pragma once

#include "io/OutputDomain.hpp"

#include <vector>

namespace asperity::io
{
// Collects nodal values of a domain on rank 0, in the order of the node numbers.
class NodeGather
{
public:
  explicit NodeGather(OutputDomain const& domain);

  // mine: (num_rows, num_owned, num_components) of this rank; on rank 0 the result is (num_rows,
  // num_global_nodes, num_components), elsewhere it is empty. Collective.
  template <class T>
  std::vector<T> operator()(std::vector<T> const& mine, std::size_t num_rows,
                            std::size_t num_components) const;

private:
  OutputDomain const& domain_;
  std::vector<GlobalOrdinal> numbers_; // rank 0: of all nodes, rank by rank
  std::vector<std::size_t> counts_;    // rank 0: of nodes, by rank
};
} // namespace asperity::io
