#include "base/parallel/GhostExchange.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Messages.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_Map.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace asperity
{
namespace
{
constexpr int tag = 7310;
const std::string label_pack = "asperity::base::packGhosts";
const std::string label_unpack = "asperity::base::unpackGhosts";
const std::string label_add = "asperity::base::addGhosts";
const std::string label_largest = "asperity::base::largestOfGhosts";

template <class T>
using Values = Kokkos::View<T*, MemorySpace>;

// to(i, k) = from(items(i), k)
template <class T>
void pack(IndexView const& items, Values<const T> const& from, int width, Values<T> const& to)
{
  Kokkos::parallel_for(
    label_pack, RangePolicy(0, items.extent_int(0)), KOKKOS_LAMBDA(int i) {
      for (int k = 0; k < width; ++k) {
        to(i * width + k) = from(items(i) * width + k);
      }
    });
}

// to(items(i), k) = from(i, k)
template <class T>
void unpack(IndexView const& items, Values<T> const& from, int width, Values<T> const& to)
{
  Kokkos::parallel_for(
    label_unpack, RangePolicy(0, items.extent_int(0)), KOKKOS_LAMBDA(int i) {
      for (int k = 0; k < width; ++k) {
        to(items(i) * width + k) = from(i * width + k);
      }
    });
}

// The ranks that own ids.
std::vector<int> ownersOf(Map const& owned, std::vector<GlobalOrdinal> const& ids)
{
  std::vector<int> owners(ids.size());
  owned.getRemoteIndexList(Teuchos::arrayViewFromVector(ids), Teuchos::arrayViewFromVector(owners));
  for (std::size_t i = 0; i < owners.size(); ++i) {
    ASPERITY_REQUIRE(owners[i] >= 0, "No rank owns the id " << ids[i] << " of a ghost.");
  }
  return owners;
}
} // namespace

GhostExchange::Side::Side(Route const& route)
    : items(route.items)
    , on_device(toDevice(items, "asperity::base::exchangedItems"))
{
  for (std::size_t i = 0; i < items.size(); ++i) {
    const int at = static_cast<int>(i);
    if (neighbours.empty() || neighbours.back().rank != route.ranks[i]) {
      neighbours.push_back({route.ranks[i], at, at});
    }
    ++neighbours.back().end;
  }
}

GhostExchange::Side GhostExchange::Side::reduced(std::vector<char> const& keeps) const
{
  Route kept;
  for (auto const& neighbour : neighbours) {
    for (int i = neighbour.begin; i < neighbour.end; ++i) {
      if (keeps[i]) {
        kept.items.push_back(items[i]);
        kept.ranks.push_back(neighbour.rank);
      }
    }
  }
  return Side(kept);
}

GhostExchange::GhostExchange(Map const& owned, std::vector<GlobalOrdinal> const& ghosts)
{
  auto const& communicator = *owned.getComm();
  if (communicator.getSize() == 1) {
    return;
  }
  const auto owners = ownersOf(owned, ghosts);
  const int num_owned = static_cast<int>(numLocalElements(owned));
  std::vector<int> order(ghosts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return owners[a] < owners[b]; });
  // Every owner is told who asks for what, in the order in which it will be received.
  Route sent, received;
  std::vector<GlobalOrdinal> questions;
  for (const int ghost : order) {
    received.items.push_back(num_owned + ghost);
    received.ranks.push_back(owners[ghost]);
    questions.push_back(communicator.getRank());
    questions.push_back(ghosts[ghost]);
  }
  const auto asked = sendItems(questions, 2, received.ranks, communicator);
  for (std::size_t i = 0; i < asked.size(); i += 2) {
    sent.ranks.push_back(static_cast<int>(asked[i]));
    sent.items.push_back(owned.getLocalElement(asked[i + 1]));
  }
  *this = GhostExchange(owned.getComm(), num_owned, sent, received);
}

GhostExchange::GhostExchange(RCP<const Communicator> communicator, int num_owned, Route const& sent,
                             Route const& received)
    : GhostExchange(std::move(communicator), num_owned, Side(sent), Side(received))
{
}

GhostExchange::GhostExchange(RCP<const Communicator> communicator, int num_owned, Side owned,
                             Side ghosts)
    : communicator_(std::move(communicator))
    , num_owned_(num_owned)
    , owned_(std::move(owned))
    , ghosts_(std::move(ghosts))
{
  std::map<int, std::vector<int>> places;
  for (std::size_t i = 0; i < owned_.items.size(); ++i) {
    places[owned_.items[i]].push_back(static_cast<int>(i));
  }
  std::vector<int> owners, begins = {0}, all;
  for (auto const& [owner, of_owner] : places) {
    owners.push_back(owner);
    all.insert(all.end(), of_owner.begin(), of_owner.end());
    begins.push_back(static_cast<int>(all.size()));
  }
  owners_ = toDevice(owners, "asperity::base::owners");
  first_place_ = toDevice(begins, "asperity::base::firstPlaces");
  places_ = toDevice(all, "asperity::base::placesOfOwners");
}

GhostExchange GhostExchange::withOwned(std::vector<char> const& is_taken) const
{
  std::vector<char> mine, theirs(ghosts_.items.size());
  for (const int item : owned_.items) {
    mine.push_back(is_taken[item]);
  }
  send(owned_, mine.data(), ghosts_, theirs.data(), 1);
  return {communicator_, num_owned_, owned_.reduced(mine), ghosts_.reduced(theirs)};
}

GhostExchange GhostExchange::withGhosts(std::vector<char> const& is_taken) const
{
  std::vector<char> mine(owned_.items.size()), theirs;
  for (const int item : ghosts_.items) {
    theirs.push_back(is_taken[item - num_owned_]);
  }
  send(ghosts_, theirs.data(), owned_, mine.data(), 1);
  return {communicator_, num_owned_, owned_.reduced(mine), ghosts_.reduced(theirs)};
}

GhostExchange GhostExchange::renumbered(std::vector<int> const& number) const
{
  Route sent;
  for (auto const& neighbour : owned_.neighbours) {
    for (int i = neighbour.begin; i < neighbour.end; ++i) {
      sent.items.push_back(number[owned_.items[i]]);
      sent.ranks.push_back(neighbour.rank);
    }
  }
  return {communicator_, num_owned_, Side(sent), ghosts_};
}

template <class T>
void GhostExchange::share(Kokkos::View<T*, MemorySpace> const& values, int width) const
{
  if (owned_.items.empty() && ghosts_.items.empty()) {
    return;
  }
  auto const& buffer = buffers<T>(width);
  pack<T>(owned_.on_device, values, width, buffer.owned);
  Kokkos::deep_copy(buffer.owned_on_host, buffer.owned);
  send(owned_, buffer.owned_on_host.data(), ghosts_, buffer.ghosts_on_host.data(), width);
  Kokkos::deep_copy(buffer.ghosts, buffer.ghosts_on_host);
  unpack<T>(ghosts_.on_device, buffer.ghosts, width, values);
}

// The values of the ghosts of this rank's items, in the order of the list of items.
template <class T>
Values<T> GhostExchange::bringBack(Kokkos::View<const T*, MemorySpace> const& from, int width) const
{
  auto const& buffer = buffers<T>(width);
  pack<T>(ghosts_.on_device, from, width, buffer.ghosts);
  Kokkos::deep_copy(buffer.ghosts_on_host, buffer.ghosts);
  send(ghosts_, buffer.ghosts_on_host.data(), owned_, buffer.owned_on_host.data(), width);
  Kokkos::deep_copy(buffer.owned, buffer.owned_on_host);
  return buffer.owned;
}

template <class T>
void GhostExchange::gather(Kokkos::View<const T*, MemorySpace> const& from, T factor,
                           Kokkos::View<T*, MemorySpace> const& into, int width) const
{
  if (owned_.items.empty() && ghosts_.items.empty()) {
    return;
  }
  auto const came = bringBack<T>(from, width);
  auto const owners = owners_, first = first_place_, places = places_;
  Kokkos::parallel_for(
    label_add, RangePolicy(0, owners.extent_int(0)), KOKKOS_LAMBDA(int i) {
      for (int place = first(i); place < first(i + 1); ++place) {
        for (int k = 0; k < width; ++k) {
          into(owners(i) * width + k) += factor * came(places(place) * width + k);
        }
      }
    });
}

template <class T>
void GhostExchange::gatherLargest(Kokkos::View<const T*, MemorySpace> const& from,
                                  Kokkos::View<T*, MemorySpace> const& into, int width) const
{
  if (owned_.items.empty() && ghosts_.items.empty()) {
    return;
  }
  auto const came = bringBack<T>(from, width);
  auto const owners = owners_, first = first_place_, places = places_;
  Kokkos::parallel_for(
    label_largest, RangePolicy(0, owners.extent_int(0)), KOKKOS_LAMBDA(int i) {
      for (int place = first(i); place < first(i + 1); ++place) {
        for (int k = 0; k < width; ++k) {
          T& largest = into(owners(i) * width + k);
          const T value = came(places(place) * width + k);
          largest = value > largest ? value : largest;
        }
      }
    });
}

template <class T>
GhostExchange::Buffers<T> const& GhostExchange::buffers(int width) const
{
  auto& buffer = std::get<Buffers<T>>(buffers_);
  const auto make = [width](Side const& side, auto& values, auto& on_host) {
    const std::size_t size = side.items.size() * static_cast<std::size_t>(width);
    if (values.extent(0) < size) {
      values = Values<T>("asperity::base::exchangedValues", size);
      on_host = Kokkos::create_mirror_view(values);
    }
  };
  make(owned_, buffer.owned, buffer.owned_on_host);
  make(ghosts_, buffer.ghosts, buffer.ghosts_on_host);
  return buffer;
}

template <class T>
void GhostExchange::send(Side const& from, T const* sent, Side const& to, T* received,
                         int width) const
{
  if (from.neighbours.empty() && to.neighbours.empty()) {
    return;
  }
  auto const comm = rawCommunicator(*communicator_);
  std::vector<MPI_Request> requests;
  requests.reserve(from.neighbours.size() + to.neighbours.size());
  const auto count = [width](Neighbour const& other) { return (other.end - other.begin) * width; };
  for (auto const& other : to.neighbours) {
    requests.emplace_back();
    MPI_Irecv(received + static_cast<std::size_t>(other.begin) * width, count(other), mpiType(T()),
              other.rank, tag, comm, &requests.back());
  }
  for (auto const& other : from.neighbours) {
    requests.emplace_back();
    MPI_Isend(sent + static_cast<std::size_t>(other.begin) * width, count(other), mpiType(T()),
              other.rank, tag, comm, &requests.back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

template void GhostExchange::share(Kokkos::View<float*, MemorySpace> const&, int) const;
template void GhostExchange::share(Kokkos::View<double*, MemorySpace> const&, int) const;
template void GhostExchange::gather(Kokkos::View<const float*, MemorySpace> const&, float,
                                    Kokkos::View<float*, MemorySpace> const&, int) const;
template void GhostExchange::gather(Kokkos::View<const double*, MemorySpace> const&, double,
                                    Kokkos::View<double*, MemorySpace> const&, int) const;
template void GhostExchange::gatherLargest(Kokkos::View<const float*, MemorySpace> const&,
                                           Kokkos::View<float*, MemorySpace> const&, int) const;
template void GhostExchange::gatherLargest(Kokkos::View<const double*, MemorySpace> const&,
                                           Kokkos::View<double*, MemorySpace> const&, int) const;
} // namespace asperity
