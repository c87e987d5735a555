#pragma once

#include "base/Types.hpp"
#include "base/parallel/Reductions.hpp"

#include <vector>

namespace asperity
{
// Returns the vectors of all ranks one after the other. T is double, GlobalOrdinal or char.
// Collective.
template <class T>
std::vector<T> gatherToAll(std::vector<T> const& mine, Communicator const& comm);
} // namespace asperity
