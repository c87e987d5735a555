#include "io/parallel/Exchange.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Messages.hpp"

#include <algorithm>
#include <numeric>

namespace asperity::io::detail
{
namespace
{
MPI_Datatype typeOf(double) { return MPI_DOUBLE; }
MPI_Datatype typeOf(GlobalOrdinal) { return MPI_LONG_LONG; }

std::vector<int> offsetsOf(std::vector<int> const& counts)
{
  std::vector<int> offsets(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), offsets.begin() + 1);
  return offsets;
}
} // namespace

template <class T>
std::vector<T> sendItems(std::vector<T> const& items, std::size_t item_size,
                         std::vector<int> const& destinations, Communicator const& comm)
{
  ASPERITY_ASSERT(items.size() == item_size * destinations.size());
  std::vector<int> sent(comm.getSize(), 0), received(comm.getSize(), 0);
  for (const int rank : destinations) {
    sent[rank] += static_cast<int>(item_size);
  }
  MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, rawCommunicator(comm));
  const auto from = offsetsOf(sent), to = offsetsOf(received);
  std::vector<T> sorted(items.size()), result(to.back());
  auto next = from;
  for (std::size_t i = 0; i < destinations.size(); ++i) {
    int& place = next[destinations[i]];
    std::copy_n(items.begin() + i * item_size, item_size, sorted.begin() + place);
    place += static_cast<int>(item_size);
  }
  MPI_Alltoallv(sorted.data(), sent.data(), from.data(), typeOf(T()), result.data(),
                received.data(), to.data(), typeOf(T()), rawCommunicator(comm));
  return result;
}

template std::vector<double> sendItems(std::vector<double> const&, std::size_t,
                                       std::vector<int> const&, Communicator const&);
template std::vector<GlobalOrdinal> sendItems(std::vector<GlobalOrdinal> const&, std::size_t,
                                              std::vector<int> const&, Communicator const&);
} // namespace asperity::io::detail
