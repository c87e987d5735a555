#include "io/parallel/NodeBlocks.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Messages.hpp"

#include <algorithm>
#include <numeric>

namespace asperity::io
{
NodeBlocks::NodeBlocks(std::vector<GlobalOrdinal> const& node_numbers, GlobalOrdinal num_global,
                       Communicator const& comm)
    : comm_(comm)
    , total_(num_global)
{
  std::vector<GlobalOrdinal> items; // number and owner
  items.reserve(2 * node_numbers.size());
  for (const GlobalOrdinal number : node_numbers) {
    destinations_.push_back(rankOf(number));
    items.insert(items.end(), {number, comm.getRank()});
  }
  const auto arrived = sendItems(items, 2, destinations_, comm);
  for (auto item = arrived.begin(); item != arrived.end(); item += 2) {
    numbers_.push_back(static_cast<std::size_t>(item[0] - first()));
    owners_.push_back(static_cast<int>(item[1]));
  }
  ASPERITY_ASSERT(static_cast<GlobalOrdinal>(numbers_.size()) == count());
}

GlobalOrdinal NodeBlocks::begin(int rank) const { return total_ * rank / comm_.getSize(); }

int NodeBlocks::rankOf(GlobalOrdinal number) const
{
  auto rank = static_cast<int>(number * comm_.getSize() / total_);
  while (number >= begin(rank + 1)) { // integer division may be one short
    ++rank;
  }
  return rank;
}

template <class T>
std::vector<T> inBlock(std::vector<T> const& mine, std::size_t owned, std::size_t num_rows,
                       std::size_t num_components, std::vector<int> const& destinations,
                       std::vector<std::size_t> const& numbers, Communicator const& comm)
{
  std::vector<T> items; // (owned, num_rows, num_components)
  items.reserve(mine.size());
  for (std::size_t i = 0; i < owned; ++i) {
    for (std::size_t row = 0; row < num_rows; ++row) {
      const auto from = mine.begin() + (row * owned + i) * num_components;
      items.insert(items.end(), from, from + num_components);
    }
  }
  const auto arrived = sendItems(items, num_rows * num_components, destinations, comm);
  std::vector<T> block(arrived.size());
  auto from = arrived.begin();
  for (const std::size_t number : numbers) {
    for (std::size_t row = 0; row < num_rows; ++row, from += num_components) {
      const std::size_t place = row * numbers.size() + number;
      std::copy_n(from, num_components, block.begin() + place * num_components);
    }
  }
  return block;
}

template std::vector<double> inBlock(std::vector<double> const&, std::size_t, std::size_t,
                                     std::size_t, std::vector<int> const&,
                                     std::vector<std::size_t> const&, Communicator const&);

template <class T>
std::vector<T> NodeBlocks::operator()(std::vector<T> const& mine, std::size_t num_rows,
                                      std::size_t num_components) const
{
  const std::size_t owned = destinations_.size();
  ASPERITY_ASSERT(mine.size() == num_rows * owned * num_components);
  return inBlock(mine, owned, num_rows, num_components, destinations_, numbers_, comm_);
}

template <class T>
std::vector<T> NodeBlocks::back(std::vector<T> const& block, std::size_t num_components) const
{
  std::vector<T> items;
  items.reserve(block.size());
  for (const std::size_t number : numbers_) {
    const auto from = block.begin() + number * num_components;
    items.insert(items.end(), from, from + num_components);
  }
  const auto arrived = sendItems(items, num_components, owners_, comm_);
  // Each rank sends its items in the order in which it has received the nodes.
  std::vector<std::size_t> order(destinations_.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [this](std::size_t left, std::size_t right) {
    return destinations_[left] < destinations_[right];
  });
  std::vector<T> mine(arrived.size());
  auto from = arrived.begin();
  for (const std::size_t node : order) {
    std::copy_n(from, num_components, mine.begin() + node * num_components);
    from += num_components;
  }
  return mine;
}

#define ASPERITY_INSTANTIATE(T)                                                                    \
  template std::vector<T> NodeBlocks::operator()(std::vector<T> const&, std::size_t, std::size_t)  \
    const;                                                                                         \
  template std::vector<T> NodeBlocks::back(std::vector<T> const&, std::size_t) const;

ASPERITY_INSTANTIATE(double)
ASPERITY_INSTANTIATE(int)
ASPERITY_INSTANTIATE(long long)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::io
