#pragma once

#include "base/Types.hpp"
#include "io/OutputDomain.hpp"

#include <functional>
#include <vector>

namespace asperity::io
{
// Calls use(block) on rank 0 for the block of every rank, that of rank 0 first. Besides its own,
// rank 0 holds one block at a time. What `use` throws is thrown on every rank. T is
// double or long long. Collective.
template <class T>
void visitInOrder(std::vector<T> const& block, Communicator const& comm,
                  std::function<void(std::vector<T> const&)> const& use);

// All blocks of nodal values of a curve, one after the other, on rank 0; empty elsewhere. A surface
// has too many nodes for one rank: std::logic_error. Collective.
std::vector<double> joinedInOrder(OutputDomain const& curve, std::vector<double> const& block);
} // namespace asperity::io
