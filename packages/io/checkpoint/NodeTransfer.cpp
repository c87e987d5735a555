#include "io/checkpoint/NodeTransfer.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Directory.hpp"
#include "base/parallel/Messages.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>
#include <numeric>
#include <type_traits>

namespace asperity::io::detail
{
namespace
{
using Items = std::vector<GlobalOrdinal>;

void refuse()
{
  throw InputError("The checkpoint has other nodes than the mesh. It belongs to another mesh.");
}
} // namespace

NodeTransfer::NodeTransfer(std::vector<std::int64_t> const& held,
                           std::vector<std::int64_t> const& wanted, Communicator const& comm)
    : comm_(comm)
{
  std::int64_t least = 0, most = 0;
  for (auto const* numbers : {&held, &wanted}) {
    for (const std::int64_t number : *numbers) {
      least = std::min(least, number);
      most = std::max(most, number);
    }
  }
  if (minOverRanks(least, comm) < 0) {
    refuse();
  }
  const Directory wishes(maxOverRanks(most, comm) + 1, comm);
  const Items asked(held.begin(), held.end()), ids(wanted.begin(), wanted.end());
  Items places(wanted.size());
  std::iota(places.begin(), places.end(), GlobalOrdinal(0));
  const auto ranks = wishes.valuesAt(asked, ids, Items(wanted.size(), comm.getRank()));
  const auto place_there = wishes.valuesAt(asked, ids, places);
  onEveryRank(comm, [&] {
    if (std::find(ranks.begin(), ranks.end(), -1) != ranks.end()) {
      refuse();
    }
  });
  destinations_.assign(ranks.begin(), ranks.end());
  auto arrived = sendItems(place_there, 1, destinations_, comm);
  places_.assign(arrived.begin(), arrived.end());
  onEveryRank(comm, [&] {
    std::sort(arrived.begin(), arrived.end());
    if (arrived != places) { // each place once
      refuse();
    }
  });
}

template <class T>
std::vector<T> NodeTransfer::operator()(std::vector<T> const& values,
                                        std::size_t num_components) const
{
  using Sent = std::conditional_t<std::is_same_v<T, double>, double, long long>;
  const auto arrived = sendItems(std::vector<Sent>(values.begin(), values.end()), num_components,
                                 destinations_, comm_);
  std::vector<T> result(arrived.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    std::copy_n(arrived.begin() + i * num_components, num_components,
                result.begin() + places_[i] * num_components);
  }
  return result;
}

template std::vector<double> NodeTransfer::operator()(std::vector<double> const&,
                                                      std::size_t) const;
template std::vector<std::int64_t> NodeTransfer::operator()(std::vector<std::int64_t> const&,
                                                            std::size_t) const;
} // namespace asperity::io::detail
