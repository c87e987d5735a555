#pragma once

#include "base/Types.hpp"
#include "io/parallel/NodeBlocks.hpp"

#include <cstdint>
#include <vector>

namespace asperity::io::detail
{
// The nodes of a set in the order of their numbers, on all ranks; it is the order of their values
// in a checkpoint.
struct NodeOrder
{
  NodeBlocks blocks;     // by place in this order
  std::int64_t checksum; // of the numbers; it does not depend on the ranks
};

// numbers: of this rank's nodes; each number occurs once on all ranks together. The communicator
// must outlive the result. Collective.
NodeOrder orderOf(std::vector<std::int64_t> const& numbers, Communicator const& comm);
} // namespace asperity::io::detail
