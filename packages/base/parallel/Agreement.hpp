#pragma once

#include "base/Types.hpp"

#include <functional>

// Errors that one rank notices, thrown on all: a rank that throws alone leaves the others waiting.
namespace asperity
{
// Runs `work` on rank 0 alone. What it throws is thrown on every rank: InputError, SolveError,
// OutputError and std::bad_alloc as themselves, the rest as std::runtime_error. Collective.
void onRoot(Communicator const& communicator, std::function<void()> const& work);

// Runs `work` on every rank; if it throws on some, the error of the lowest of them is thrown on
// every rank, as by onRoot. `work` must not contain collective calls: a rank that has failed would
// wait here for the others, while they wait for it in the call. Collective.
void onEveryRank(Communicator const& communicator, std::function<void()> const& work);
} // namespace asperity
