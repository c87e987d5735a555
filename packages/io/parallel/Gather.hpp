#pragma once

#include "base/Types.hpp"
#include "base/parallel/Reductions.hpp"

#include <vector>

namespace asperity::io
{
// The ranks' vectors one after the other, on rank 0 or on all; empty elsewhere. T is double,
// GlobalOrdinal or char. Collective.
template <class T>
std::vector<T> gatherToRoot(std::vector<T> const& mine, Communicator const& comm);

template <class T>
std::vector<T> gatherToAll(std::vector<T> const& mine, Communicator const& comm);
} // namespace asperity::io
