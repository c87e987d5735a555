#include "io/checkpoint/NodeTransfer.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Messages.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>
#include <array>
#include <map>
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

// Equal blocks of node numbers, one for each rank, which finds who holds and who wants each number.
class Blocks
{
public:
  Blocks(std::vector<std::int64_t> const& held, std::vector<std::int64_t> const& wanted,
         Communicator const& comm)
  {
    std::int64_t end = 1, least = 0;
    for (auto const* numbers : {&held, &wanted}) {
      for (const std::int64_t number : *numbers) {
        end = std::max(end, number + 1);
        least = std::min(least, number);
      }
    }
    if (minOverRanks(least, comm) < 0) {
      refuse();
    }
    length_ = (maxOverRanks(end, comm) + comm.getSize() - 1) / comm.getSize();
  }

  std::vector<int> of(std::vector<std::int64_t> const& numbers) const
  {
    std::vector<int> ranks;
    ranks.reserve(numbers.size());
    for (const std::int64_t number : numbers) {
      ranks.push_back(static_cast<int>(number / length_));
    }
    return ranks;
  }

private:
  std::int64_t length_ = 1;
};

// (num_numbers, 3): the number, this rank, and the place in the list.
Items itemsOf(std::vector<std::int64_t> const& numbers, int rank)
{
  Items items;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    items.insert(items.end(), {numbers[i], rank, static_cast<GlobalOrdinal>(i)});
  }
  return items;
}
} // namespace

NodeTransfer::NodeTransfer(std::vector<std::int64_t> const& held,
                           std::vector<std::int64_t> const& wanted, Communicator const& comm)
    : comm_(comm)
{
  const Blocks blocks(held, wanted, comm);
  const auto asked = sendItems(itemsOf(wanted, comm.getRank()), 3, blocks.of(wanted), comm);
  const auto offered = sendItems(itemsOf(held, comm.getRank()), 3, blocks.of(held), comm);
  std::map<GlobalOrdinal, std::array<GlobalOrdinal, 2>> wish; // rank and place, by number
  for (std::size_t i = 0; i < asked.size(); i += 3) {
    wish[asked[i]] = {asked[i + 1], asked[i + 2]};
  }
  Items answers; // (num_offered, 3): place where it is held, rank and place where it is wanted
  std::vector<int> holders;
  onEveryRank(comm, [&] {
    for (std::size_t i = 0; i < offered.size(); i += 3) {
      const auto found = wish.find(offered[i]);
      if (found == wish.end()) {
        refuse();
      }
      answers.insert(answers.end(), {offered[i + 2], found->second[0], found->second[1]});
      holders.push_back(static_cast<int>(offered[i + 1]));
      wish.erase(found);
    }
    if (!wish.empty()) {
      refuse();
    }
  });
  const auto answered = sendItems(answers, 3, holders, comm);
  destinations_.resize(held.size());
  Items place_there(held.size());
  for (std::size_t i = 0; i < answered.size(); i += 3) {
    destinations_[answered[i]] = static_cast<int>(answered[i + 1]);
    place_there[answered[i]] = answered[i + 2];
  }
  const auto arrived = sendItems(place_there, 1, destinations_, comm);
  places_.assign(arrived.begin(), arrived.end());
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
