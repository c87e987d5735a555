#pragma once

#include "base/Errors.hpp"
#include "base/Types.hpp"

#include <string>
#include <vector>

namespace asperity::mesh::detail
{
// InputError with the message of the lowest rank that has one, on every rank; `problem` is empty
// where nothing is wrong. Collective.
void requireOnEveryRank(std::string const& problem, Communicator const& communicator);

// Calls work() on this rank. If it throws an InputError on any, every rank throws that of the
// lowest. Collective, so `work` must not be.
template <class Work>
void onEveryRank(Communicator const& communicator, Work work)
{
  std::string problem;
  try {
    work();
  } catch (InputError const& error) {
    problem = error.what();
  }
  requireOnEveryRank(problem, communicator);
}

// What is not zero here or on any other rank is not zero in the answer. Collective.
std::vector<int> onAnyRank(std::vector<int> const& flags, Communicator const& communicator);
} // namespace asperity::mesh::detail
