#include "tnnmg/Halo.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Messages.hpp"

#include <Tpetra_Map.hpp>

#include <algorithm>
#include <numeric>

namespace asperity::tnnmg
{
namespace
{
constexpr int tag = 7310;

template <class T, class Neighbours>
void exchange(Neighbours const& to, T const* sent, Neighbours const& from, T* received,
              RCP<const Communicator> const& communicator)
{
  if (to.empty() && from.empty()) {
    return;
  }
  auto const comm = rawCommunicator(*communicator);
  std::vector<MPI_Request> requests;
  requests.reserve(to.size() + from.size());
  for (auto const& neighbour : from) {
    requests.emplace_back();
    MPI_Irecv(received + neighbour.begin, neighbour.end - neighbour.begin, mpiType(T()),
              neighbour.rank, tag, comm, &requests.back());
  }
  for (auto const& neighbour : to) {
    requests.emplace_back();
    MPI_Isend(sent + neighbour.begin, neighbour.end - neighbour.begin, mpiType(T()), neighbour.rank,
              tag, comm, &requests.back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}
} // namespace

Halo::Halo(Map const& owned, std::vector<GlobalOrdinal> const& ghosts)
    : communicator_(owned.getComm())
{
  if (communicator_->getSize() == 1) {
    return;
  }
  std::vector<int> owners(ghosts.size());
  owned.getRemoteIndexList(Teuchos::arrayViewFromVector(ghosts),
                           Teuchos::arrayViewFromVector(owners));
  for (std::size_t i = 0; i < owners.size(); ++i) {
    ASPERITY_REQUIRE(owners[i] >= 0, "No rank owns the id " << ghosts[i] << " of a halo.");
  }
  received_.resize(ghosts.size());
  std::iota(received_.begin(), received_.end(), 0);
  std::stable_sort(received_.begin(), received_.end(),
                   [&](int a, int b) { return owners[a] < owners[b]; });
  // Every owner is told who asks for what, in the order in which it will be received.
  std::vector<GlobalOrdinal> questions;
  std::vector<int> destinations;
  for (const int place : received_) {
    const int owner = owners[place];
    const int at = static_cast<int>(destinations.size());
    destinations.push_back(owner);
    questions.push_back(communicator_->getRank());
    questions.push_back(ghosts[place]);
    if (from_.empty() || from_.back().rank != owner) {
      from_.push_back({owner, at, at});
    }
    ++from_.back().end;
  }
  const auto asked = sendItems(questions, 2, destinations, *communicator_);
  for (std::size_t i = 0; i < asked.size(); i += 2) {
    const int rank = static_cast<int>(asked[i]), at = static_cast<int>(sent_.size());
    sent_.push_back(owned.getLocalElement(asked[i + 1]));
    if (to_.empty() || to_.back().rank != rank) {
      to_.push_back({rank, at, at});
    }
    ++to_.back().end;
  }
}

Halo Halo::withOwned(std::vector<char> const& is_taken) const
{
  std::vector<char> mine(sent_.size()), theirs(received_.size());
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    mine[i] = is_taken[sent_[i]];
  }
  share(mine.data(), theirs.data());
  return reduced(mine, theirs);
}

Halo Halo::withGhosts(std::vector<char> const& is_taken) const
{
  std::vector<char> mine(sent_.size()), theirs(received_.size());
  for (std::size_t i = 0; i < received_.size(); ++i) {
    theirs[i] = is_taken[received_[i]];
  }
  gather(theirs.data(), mine.data());
  return reduced(mine, theirs);
}

Halo Halo::reduced(std::vector<char> const& keeps_sent,
                   std::vector<char> const& keeps_received) const
{
  const auto reduce = [](std::vector<char> const& keeps, std::vector<int> const& places,
                         std::vector<Neighbour> const& neighbours, std::vector<int>& new_places,
                         std::vector<Neighbour>& new_neighbours) {
    for (auto const& neighbour : neighbours) {
      const int begin = static_cast<int>(new_places.size());
      for (int i = neighbour.begin; i < neighbour.end; ++i) {
        if (keeps[i]) {
          new_places.push_back(places[i]);
        }
      }
      if (const int end = static_cast<int>(new_places.size()); end > begin) {
        new_neighbours.push_back({neighbour.rank, begin, end});
      }
    }
  };
  Halo halo;
  halo.communicator_ = communicator_;
  reduce(keeps_sent, sent_, to_, halo.sent_, halo.to_);
  reduce(keeps_received, received_, from_, halo.received_, halo.from_);
  return halo;
}

template <class T>
void Halo::share(T const* sent, T* received) const
{
  exchange(to_, sent, from_, received, communicator_);
}

template <class T>
void Halo::gather(T const* received, T* sent) const
{
  exchange(from_, received, to_, sent, communicator_);
}

template void Halo::share(char const*, char*) const;
template void Halo::share(float const*, float*) const;
template void Halo::share(double const*, double*) const;
template void Halo::gather(char const*, char*) const;
template void Halo::gather(float const*, float*) const;
template void Halo::gather(double const*, double*) const;
} // namespace asperity::tnnmg
