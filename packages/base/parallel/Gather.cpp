#include "base/parallel/Gather.hpp"

#include "base/parallel/Messages.hpp"

namespace asperity
{
namespace
{
struct Blocks
{
  std::vector<int> counts, offsets; // (num_ranks)
  int total = 0;
};

// MPI counts with int: what is too large for that is refused on every rank.
Blocks blocksOfRanks(std::size_t mine, Communicator const& comm)
{
  const auto count = static_cast<std::int64_t>(mine);
  std::vector<std::int64_t> counts(static_cast<std::size_t>(comm.getSize()));
  MPI_Allgather(&count, 1, MPI_INT64_T, counts.data(), 1, MPI_INT64_T, rawCommunicator(comm));
  Blocks blocks;
  blocks.offsets = blockOffsets(counts, "What one rank gathers from all");
  blocks.total = blocks.offsets.back();
  blocks.offsets.pop_back();
  blocks.counts.assign(counts.begin(), counts.end());
  return blocks;
}
} // namespace

template <class T>
std::vector<T> gatherToRoot(std::vector<T> const& mine, Communicator const& comm)
{
  const Blocks blocks = blocksOfRanks(mine.size(), comm);
  std::vector<T> all(comm.getRank() == 0 ? blocks.total : 0);
  MPI_Gatherv(mine.data(), static_cast<int>(mine.size()), mpiType(T()), all.data(),
              blocks.counts.data(), blocks.offsets.data(), mpiType(T()), 0, rawCommunicator(comm));
  return all;
}

template <class T>
std::vector<T> gatherToAll(std::vector<T> const& mine, Communicator const& comm)
{
  const Blocks blocks = blocksOfRanks(mine.size(), comm);
  std::vector<T> all(blocks.total);
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), mpiType(T()), all.data(),
                 blocks.counts.data(), blocks.offsets.data(), mpiType(T()), rawCommunicator(comm));
  return all;
}

template std::vector<double> gatherToRoot(std::vector<double> const&, Communicator const&);
template std::vector<GlobalOrdinal> gatherToRoot(std::vector<GlobalOrdinal> const&,
                                                 Communicator const&);
template std::vector<char> gatherToRoot(std::vector<char> const&, Communicator const&);
template std::vector<double> gatherToAll(std::vector<double> const&, Communicator const&);
template std::vector<GlobalOrdinal> gatherToAll(std::vector<GlobalOrdinal> const&,
                                                Communicator const&);
template std::vector<char> gatherToAll(std::vector<char> const&, Communicator const&);
} // namespace asperity
