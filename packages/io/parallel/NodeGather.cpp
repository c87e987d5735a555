#include "io/parallel/NodeGather.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Gather.hpp"

#include <algorithm>

namespace asperity::io
{
NodeGather::NodeGather(OutputDomain const& domain) : domain_(domain)
{
  numbers_ = gatherToRoot(domain.node_numbers, *domain.comm);
  const std::vector<GlobalOrdinal> mine{static_cast<GlobalOrdinal>(domain.numOwned())};
  for (const GlobalOrdinal count : gatherToRoot(mine, *domain.comm)) {
    counts_.push_back(static_cast<std::size_t>(count));
  }
}

template <class T>
std::vector<T> NodeGather::operator()(std::vector<T> const& mine, std::size_t num_rows,
                                      std::size_t num_components) const
{
  ASPERITY_ASSERT(mine.size() == num_rows * domain_.numOwned() * num_components);
  const std::vector<T> all = gatherToRoot(mine, *domain_.comm);
  std::vector<T> ordered(all.size());
  auto from = all.begin();
  auto number = numbers_.begin();
  for (const std::size_t count : counts_) { // (rows, nodes of this rank, components)
    for (std::size_t row = 0; row < num_rows; ++row) {
      const std::size_t first = row * numbers_.size();
      for (std::size_t i = 0; i < count; ++i, from += num_components) {
        std::copy_n(from, num_components,
                    ordered.begin() + (first + *(number + i)) * num_components);
      }
    }
    number += count;
  }
  return ordered;
}

template std::vector<double> NodeGather::operator()(std::vector<double> const&, std::size_t,
                                                    std::size_t) const;
template std::vector<GlobalOrdinal> NodeGather::operator()(std::vector<GlobalOrdinal> const&,
                                                           std::size_t, std::size_t) const;
} // namespace asperity::io
