#pragma once

#include "base/Types.hpp"

#include <cstdint>
#include <vector>

namespace asperity::io::detail
{
// Sends values at nodes from the ranks that hold them to those that want them. Nodes have numbers
// that do not depend on the ranks; each is held once and wanted once.
class NodeTransfer
{
public:
  // Throws InputError on every rank if other nodes are held than are wanted. Collective.
  NodeTransfer(std::vector<std::int64_t> const& held, std::vector<std::int64_t> const& wanted,
               Communicator const& comm);

  // values(num_held, num_components); the result is (num_wanted, num_components). T is double or
  // std::int64_t. Collective.
  template <class T>
  std::vector<T> operator()(std::vector<T> const& values, std::size_t num_components) const;

private:
  Communicator const& comm_;        // has to outlive this
  std::vector<int> destinations_;   // (num_held)
  std::vector<std::size_t> places_; // (num_wanted) of what arrives, in this order
};
} // namespace asperity::io::detail
