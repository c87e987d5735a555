#pragma once

#include "base/Types.hpp"

#include <cstdint>
#include <map>
#include <string>

// What this rank sent: counted by functions of MPI's profiling interface in this program, by the
// name of the work that it was sent for (asperity::currentWork).
struct MessageCount
{
  std::int64_t messages = 0;   // point to point
  std::int64_t bytes = 0;      // in these
  std::int64_t reductions = 0; // and other collective calls
};

using MessageCounts = std::map<std::string, MessageCount>;

// Since the program started.
MessageCounts messagesSoFar();

// sum += after - before
void addDifference(MessageCounts const& after, MessageCounts const& before, MessageCounts& sum);

// The largest count of a rank, number by number, for all names of any rank. Collective.
MessageCounts largestOfRanks(MessageCounts const& mine, asperity::Communicator const& communicator);
