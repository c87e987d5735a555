#include "base/parallel/Directory.hpp"

#include "base/parallel/Messages.hpp"

#include <algorithm>

namespace asperity
{
Directory::Directory(GlobalOrdinal num_ids, Communicator const& communicator)
    : block_((num_ids + communicator.getSize() - 1) / communicator.getSize())
    , first_(block_ * communicator.getRank())
    , communicator_(communicator)
{
}

std::vector<int> Directory::ranksOf(std::vector<GlobalOrdinal> const& ids) const
{
  std::vector<int> ranks;
  ranks.reserve(ids.size());
  for (const GlobalOrdinal id : ids) {
    ranks.push_back(static_cast<int>(id / block_));
  }
  return ranks;
}

// The values of this rank's block of ids, (block_): -1 where nobody sent one.
std::vector<GlobalOrdinal> Directory::receive(std::vector<GlobalOrdinal> const& ids,
                                              std::vector<GlobalOrdinal> const& values) const
{
  Rows sent;
  sent.reserve(2 * ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    sent.insert(sent.end(), {ids[i], values[i]});
  }
  const Rows received = sendItems(sent, 2, ranksOf(ids), communicator_);
  std::vector<GlobalOrdinal> here(static_cast<std::size_t>(block_), -1);
  for (std::size_t i = 0; i < received.size(); i += 2) {
    here.at(static_cast<std::size_t>(received[i] - first_)) = received[i + 1];
  }
  return here;
}

// What `here` has at these ids, each on the rank of its block.
std::vector<GlobalOrdinal> Directory::lookUp(std::vector<GlobalOrdinal> const& asked,
                                             std::vector<GlobalOrdinal> const& here) const
{
  const auto answer = [&](GlobalOrdinal const* id, Rows& reply) {
    reply.push_back(here.at(static_cast<std::size_t>(*id - first_)));
  };
  const Rows rows = ask(asked, 1, ranksOf(asked), 1, answer, communicator_);
  std::vector<GlobalOrdinal> values(asked.size(), -1);
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    values[static_cast<std::size_t>(rows[i])] = rows[i + 1];
  }
  return values;
}

std::vector<GlobalOrdinal> Directory::valuesAt(std::vector<GlobalOrdinal> const& asked,
                                               std::vector<GlobalOrdinal> const& ids,
                                               std::vector<GlobalOrdinal> const& values) const
{
  return lookUp(asked, receive(ids, values));
}

std::vector<GlobalOrdinal> Directory::sumsBefore(std::vector<GlobalOrdinal> const& asked,
                                                 std::vector<GlobalOrdinal> const& ids,
                                                 std::vector<GlobalOrdinal> const& values) const
{
  auto here = receive(ids, values);
  GlobalOrdinal sum = 0, before = 0;
  for (auto& entry : here) {
    const GlobalOrdinal value = std::max(entry, GlobalOrdinal(0));
    entry = sum;
    sum += value;
  }
  MPI_Exscan(&sum, &before, 1, mpiType(sum), MPI_SUM, rawCommunicator(communicator_));
  before = communicator_.getRank() == 0 ? 0 : before; // MPI leaves it undefined there
  for (auto& entry : here) {
    entry += before;
  }
  return lookUp(asked, here);
}
} // namespace asperity
