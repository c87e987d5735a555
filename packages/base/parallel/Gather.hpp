#pragma once

#include "base/Types.hpp"
#include "base/parallel/Reductions.hpp"

#include <vector>

namespace asperity
{
// Return the vectors of all ranks one after the other, on rank 0 (empty elsewhere) or on all ranks.
// T is double, GlobalOrdinal or char. Collective.
template <class T>
std::vector<T> gatherToRoot(std::vector<T> const& mine, Communicator const& comm);

template <class T>
std::vector<T> gatherToAll(std::vector<T> const& mine, Communicator const& comm);
} // namespace asperity
