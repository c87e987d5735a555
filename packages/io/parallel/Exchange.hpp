#pragma once

#include "base/Types.hpp"

#include <vector>

namespace asperity::io::detail
{
// Sends every item to a rank: items (num_items, item_size), destinations (num_items). Returns the
// items sent to this rank, (any number, item_size): those of rank 0 first, and those of each rank
// in the order in which it has them. T is double or GlobalOrdinal. Collective.
template <class T>
std::vector<T> sendItems(std::vector<T> const& items, std::size_t item_size,
                         std::vector<int> const& destinations, Communicator const& comm);
} // namespace asperity::io::detail
