#pragma once

#include "base/Types.hpp"

#include <mpi.h>

#include <functional>
#include <vector>

namespace asperity::io::detail
{
// MPI_COMM_SELF of a communicator without MPI.
MPI_Comm rawCommunicator(Communicator const& comm);

// The ranks' vectors one after the other, on rank 0 or on all; empty elsewhere. T is double,
// GlobalOrdinal or char. Collective.
template <class T>
std::vector<T> gatherToRoot(std::vector<T> const& mine, Communicator const& comm);

template <class T>
std::vector<T> gatherToAll(std::vector<T> const& mine, Communicator const& comm);

// Runs `work` on rank 0 alone. What it throws is thrown on every rank: InputError as itself, the
// rest as std::runtime_error. Collective.
void onRoot(Communicator const& comm, std::function<void()> const& work);

// Runs `work` on every rank; if it throws on some, the error of the first of them is thrown on
// every rank, as by onRoot. For work that is collective itself: one step of it at a time, because
// a rank that has failed takes no part in the next one. Collective.
void onAll(Communicator const& comm, std::function<void()> const& work);

double maxOverRanks(double value, Communicator const& comm);
double minOverRanks(double value, Communicator const& comm);
double sumOverRanks(double value, Communicator const& comm);
} // namespace asperity::io::detail
