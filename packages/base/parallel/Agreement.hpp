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
// every rank, as by onRoot. Of work that is collective itself give one step at a time, because a
// rank that has failed takes no part in the next one. Where others do not come to the end of a step
// that is collective itself, because this rank has failed in its middle, it throws alone after
// `patience` seconds, which ends the program. Collective.
void onEveryRank(Communicator const& communicator, std::function<void()> const& work,
                 double patience = 10);
} // namespace asperity
