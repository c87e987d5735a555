#include "base/parallel/Messages.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace asperity
{
namespace
{
constexpr std::int64_t largest_int = std::numeric_limits<int>::max();

[[noreturn]] void refuseCount(char const* what, std::int64_t count)
{
  throw InputError(std::string(what) + " would have " + std::to_string(count) +
                   " numbers, and MPI counts up to " + std::to_string(largest_int) +
                   ". Use more ranks, or a coarser mesh.");
}

std::vector<int> offsetsOf(std::vector<int> const& counts)
{
  std::vector<int> offsets(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), offsets.begin() + 1);
  return offsets;
}

// How many numbers this rank sends to each rank, and how many it receives from each.
struct Traffic
{
  std::vector<int> sent, received;
};

Traffic traffic(std::size_t item_size, std::vector<int> const& destinations,
                Communicator const& communicator)
{
  const auto num_ranks = static_cast<std::size_t>(communicator.getSize());
  std::vector<std::int64_t> sent(num_ranks, 0), received(num_ranks, 0);
  for (const int rank : destinations) {
    sent[static_cast<std::size_t>(rank)] += static_cast<std::int64_t>(item_size);
  }
  MPI_Alltoall(sent.data(), 1, MPI_INT64_T, received.data(), 1, MPI_INT64_T,
               rawCommunicator(communicator));
  const std::int64_t zero = 0;
  const auto most = maxOverRanks(std::max(std::accumulate(sent.begin(), sent.end(), zero),
                                          std::accumulate(received.begin(), received.end(), zero)),
                                 communicator);
  if (most > largest_int) {
    refuseCount("A message between ranks", most);
  }
  return {{sent.begin(), sent.end()}, {received.begin(), received.end()}};
}
} // namespace

Pieces::Pieces(std::uint64_t total, std::size_t piece) : total_(total), piece_(piece)
{
  ASPERITY_ASSERT(piece > 0 && piece <= largest_piece);
}

int Pieces::size(std::uint64_t i) const
{
  return static_cast<int>(std::min(piece_, total_ - first(i)));
}

MPI_Comm rawCommunicator(Communicator const& communicator)
{
  auto const* mpi = dynamic_cast<Teuchos::MpiComm<int> const*>(&communicator);
  return mpi ? static_cast<MPI_Comm>(*mpi->getRawMpiComm()) : MPI_COMM_SELF;
}

template <class T>
std::vector<T> sendItems(std::vector<T> const& items, std::size_t item_size,
                         std::vector<int> const& destinations, Communicator const& communicator)
{
  ASPERITY_ASSERT(items.size() == item_size * destinations.size());
  const auto counts = traffic(item_size, destinations, communicator);
  const auto from = offsetsOf(counts.sent), to = offsetsOf(counts.received);
  std::vector<T> sorted(items.size()), result(static_cast<std::size_t>(to.back()));
  auto next = from;
  for (std::size_t i = 0; i < destinations.size(); ++i) {
    int& place = next[static_cast<std::size_t>(destinations[i])];
    std::copy_n(items.begin() + i * item_size, item_size, sorted.begin() + place);
    place += static_cast<int>(item_size);
  }
  MPI_Alltoallv(sorted.data(), counts.sent.data(), from.data(), mpiType(T()), result.data(),
                counts.received.data(), to.data(), mpiType(T()), rawCommunicator(communicator));
  return result;
}

std::vector<int> blockOffsets(std::vector<std::int64_t> const& counts, char const* what)
{
  std::vector<int> offsets = {0};
  std::int64_t end = 0;
  for (const std::int64_t count : counts) {
    end += count;
    if (end > largest_int) {
      refuseCount(what, std::accumulate(counts.begin(), counts.end(), std::int64_t(0)));
    }
    offsets.push_back(static_cast<int>(end));
  }
  return offsets;
}

template std::vector<double> sendItems(std::vector<double> const&, std::size_t,
                                       std::vector<int> const&, Communicator const&);
template std::vector<int> sendItems(std::vector<int> const&, std::size_t, std::vector<int> const&,
                                    Communicator const&);
template std::vector<long long> sendItems(std::vector<long long> const&, std::size_t,
                                          std::vector<int> const&, Communicator const&);
} // namespace asperity
