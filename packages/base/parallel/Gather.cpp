#include "base/parallel/Gather.hpp"

#include "base/parallel/Messages.hpp"

namespace asperity
{
// MPI counts with int: what is too large for that is refused on every rank.
template <class T>
std::vector<T> gatherToAll(std::vector<T> const& mine, Communicator const& comm)
{
  const MPI_Comm raw = rawCommunicator(comm);
  const auto count = static_cast<std::int64_t>(mine.size());
  std::vector<std::int64_t> all_counts(static_cast<std::size_t>(comm.getSize()));
  MPI_Allgather(&count, 1, MPI_INT64_T, all_counts.data(), 1, MPI_INT64_T, raw);
  const auto offsets = blockOffsets(all_counts, "What one rank gathers from all");
  const std::vector<int> counts(all_counts.begin(), all_counts.end());
  std::vector<T> all(offsets.back());
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), mpiType(T()), all.data(),
                 counts.data(), offsets.data(), mpiType(T()), raw);
  return all;
}

template std::vector<double> gatherToAll(std::vector<double> const&, Communicator const&);
template std::vector<GlobalOrdinal> gatherToAll(std::vector<GlobalOrdinal> const&,
                                                Communicator const&);
template std::vector<char> gatherToAll(std::vector<char> const&, Communicator const&);
} // namespace asperity
