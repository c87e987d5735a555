#include "refinement/detail/Directory.hpp"

#include "base/Errors.hpp"
#include "refinement/detail/Questions.hpp"

namespace asperity::refinement::detail
{
// The values of this rank's block of ids, (block_): -1 where nobody sent one.
std::vector<GlobalOrdinal> Directory::receive(std::vector<GlobalOrdinal> const& ids,
                                              std::vector<GlobalOrdinal> const& values) const
{
  Rows sent;
  std::vector<int> destinations;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    sent.insert(sent.end(), {ids[i], values[i]});
    destinations.push_back(rankOf(ids[i]));
  }
  const Rows received = sendItems(sent, 2, destinations, communicator_);
  std::vector<GlobalOrdinal> here(static_cast<std::size_t>(block_), -1);
  for (std::size_t i = 0; i < received.size(); i += 2) {
    here.at(static_cast<std::size_t>(received[i] - first_)) = received[i + 1];
  }
  return here;
}

// The values at these ids, of which `here` are those of this rank's block.
std::vector<GlobalOrdinal> Directory::lookUp(std::vector<GlobalOrdinal> const& ids,
                                             std::vector<GlobalOrdinal> const& here) const
{
  std::vector<int> destinations;
  destinations.reserve(ids.size());
  for (const GlobalOrdinal id : ids) {
    destinations.push_back(rankOf(id));
  }
  const auto answer = [&](GlobalOrdinal const* id, Rows& reply) {
    reply.push_back(here.at(static_cast<std::size_t>(*id - first_)));
  };
  const Rows rows = ask(ids, 1, destinations, 1, answer, communicator_);
  std::vector<GlobalOrdinal> values(ids.size(), -1);
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    values[static_cast<std::size_t>(rows[i])] = rows[i + 1];
  }
  return values;
}

template <int Dim>
std::vector<int> Directory::owners(Mesh<Dim> const& part) const
{
  const auto first_ghost = part.global_ids.begin() + part.num_owned;
  const std::vector<GlobalOrdinal> owned(part.global_ids.begin(), first_ghost);
  const std::vector<GlobalOrdinal> ghosts(first_ghost, part.global_ids.end());
  const std::vector<GlobalOrdinal> me(owned.size(), communicator_.getRank());
  const auto of_ghosts = lookUp(ghosts, receive(owned, me));
  std::vector<int> result(me.begin(), me.end());
  for (const GlobalOrdinal rank : of_ghosts) {
    ASPERITY_ASSERT(rank >= 0);
    result.push_back(static_cast<int>(rank));
  }
  return result;
}

std::vector<GlobalOrdinal> Directory::sumsBefore(std::vector<GlobalOrdinal> const& ids,
                                                 std::vector<GlobalOrdinal> const& counts) const
{
  auto here = receive(ids, counts);
  GlobalOrdinal sum = 0, before = 0;
  for (auto& entry : here) {
    const GlobalOrdinal count = std::max(entry, GlobalOrdinal(0));
    entry = sum;
    sum += count;
  }
  MPI_Exscan(&sum, &before, 1, MPI_LONG_LONG, MPI_SUM, rawCommunicator(communicator_));
  before = communicator_.getRank() == 0 ? 0 : before; // MPI leaves it undefined there
  for (auto& entry : here) {
    entry += before;
  }
  return lookUp(ids, here);
}

template std::vector<int> Directory::owners(Mesh<2> const&) const;
template std::vector<int> Directory::owners(Mesh<3> const&) const;
} // namespace asperity::refinement::detail
