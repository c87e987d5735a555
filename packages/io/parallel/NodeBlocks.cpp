#include "io/parallel/NodeBlocks.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Messages.hpp"

#include <algorithm>

namespace asperity::io
{
NodeBlocks::NodeBlocks(OutputDomain const& domain) : domain_(domain)
{
  for (const GlobalOrdinal number : domain.node_numbers) {
    destinations_.push_back(rankOf(number));
  }
  for (const GlobalOrdinal number :
       sendItems(domain.node_numbers, 1, destinations_, *domain.comm)) {
    numbers_.push_back(static_cast<std::size_t>(number - first()));
  }
  ASPERITY_ASSERT(static_cast<GlobalOrdinal>(numbers_.size()) == count());
}

GlobalOrdinal NodeBlocks::begin(int rank) const
{
  return domain_.num_global_nodes * rank / domain_.comm->getSize();
}

int NodeBlocks::rankOf(GlobalOrdinal number) const
{
  const int ranks = domain_.comm->getSize();
  auto rank = static_cast<int>(number * ranks / domain_.num_global_nodes);
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
  ASPERITY_ASSERT(mine.size() == num_rows * domain_.numOwned() * num_components);
  return inBlock(mine, domain_.numOwned(), num_rows, num_components, destinations_, numbers_,
                 *domain_.comm);
}

template std::vector<double> NodeBlocks::operator()(std::vector<double> const&, std::size_t,
                                                    std::size_t) const;
template std::vector<GlobalOrdinal> NodeBlocks::operator()(std::vector<GlobalOrdinal> const&,
                                                           std::size_t, std::size_t) const;
} // namespace asperity::io
