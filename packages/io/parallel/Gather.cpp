#include "io/parallel/Gather.hpp"

#include "base/parallel/Messages.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <numeric>

namespace asperity::io
{
namespace
{
MPI_Datatype typeOf(double) { return MPI_DOUBLE; }
MPI_Datatype typeOf(GlobalOrdinal) { return MPI_LONG_LONG; }
MPI_Datatype typeOf(char) { return MPI_CHAR; }

struct Blocks
{
  std::vector<int> counts, offsets;
  int total = 0;
};

Blocks blocksOfRanks(std::size_t mine, Communicator const& comm)
{
  Blocks blocks;
  const int count = static_cast<int>(mine);
  blocks.counts.resize(comm.getSize());
  blocks.offsets.resize(comm.getSize(), 0);
  MPI_Allgather(&count, 1, MPI_INT, blocks.counts.data(), 1, MPI_INT, rawCommunicator(comm));
  std::partial_sum(blocks.counts.begin(), blocks.counts.end() - 1, blocks.offsets.begin() + 1);
  blocks.total = blocks.offsets.back() + blocks.counts.back();
  return blocks;
}
} // namespace

template <class T>
std::vector<T> gatherToRoot(std::vector<T> const& mine, Communicator const& comm)
{
  const Blocks blocks = blocksOfRanks(mine.size(), comm);
  std::vector<T> all(comm.getRank() == 0 ? blocks.total : 0);
  MPI_Gatherv(mine.data(), static_cast<int>(mine.size()), typeOf(T()), all.data(),
              blocks.counts.data(), blocks.offsets.data(), typeOf(T()), 0, rawCommunicator(comm));
  return all;
}

template <class T>
std::vector<T> gatherToAll(std::vector<T> const& mine, Communicator const& comm)
{
  const Blocks blocks = blocksOfRanks(mine.size(), comm);
  std::vector<T> all(blocks.total);
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), typeOf(T()), all.data(),
                 blocks.counts.data(), blocks.offsets.data(), typeOf(T()), rawCommunicator(comm));
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
} // namespace asperity::io
