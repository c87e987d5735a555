#include "io/parallel/ElementBlocks.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Messages.hpp"

#include <algorithm>
#include <numeric>

namespace asperity::io
{
namespace
{
struct Element
{
  GlobalOrdinal wraps;
  std::vector<GlobalOrdinal> sorted;
};
bool operator<(Element const& left, Element const& right)
{
  return left.wraps != right.wraps ? left.wraps < right.wraps : left.sorted < right.sorted;
}
} // namespace

ElementBlocks::ElementBlocks(OutputDomain const& domain, NodeBlocks const& blocks) : domain_(domain)
{
  const std::size_t corners = domain.nodes_per_element;
  std::vector<GlobalOrdinal> items; // nodes and, after them, whether it reaches across
  for (std::size_t element = 0; element < domain.numOwnedElements(); ++element) {
    const auto nodes = domain.connectivity.begin() + static_cast<std::ptrdiff_t>(element * corners);
    const auto end = nodes + domain.nodes_per_element;
    destinations_.push_back(domain.wraps[element] != 0
                              ? domain.comm->getSize() - 1
                              : blocks.rankOf(*std::min_element(nodes, end)));
    items.insert(items.end(), nodes, end);
    items.push_back(domain.wraps[element]);
  }
  const auto arrived = sendItems(items, corners + 1, destinations_, *domain.comm);
  std::vector<Element> elements;
  for (auto item = arrived.begin(); item != arrived.end(); item += domain.nodes_per_element + 1) {
    elements.push_back({item[domain.nodes_per_element], {item, item + domain.nodes_per_element}});
    std::sort(elements.back().sorted.begin(), elements.back().sorted.end());
  }
  std::vector<std::size_t> order(elements.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&elements](std::size_t left, std::size_t right) {
    return elements[left] < elements[right];
  });
  numbers_.resize(order.size());
  GlobalOrdinal whole = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    numbers_[order[i]] = i;
    whole += elements[order[i]].wraps == 0 ? 1 : 0;
    const auto nodes = arrived.begin() + static_cast<std::ptrdiff_t>(order[i] * (corners + 1));
    nodes_.insert(nodes_.end(), nodes, nodes + domain.nodes_per_element);
  }
  const auto counts = gatherToAll(std::vector<GlobalOrdinal>{count(), whole}, *domain.comm);
  for (int rank = 0; rank < domain.comm->getSize(); ++rank) {
    first_ = rank == domain.comm->getRank() ? total_ : first_;
    total_ += counts[2 * rank];
    num_whole_ += counts[2 * rank + 1];
  }
}

std::vector<double> ElementBlocks::operator()(std::vector<double> const& mine, std::size_t num_rows,
                                              std::size_t num_components) const
{
  const std::size_t owned = domain_.numOwnedElements();
  ASPERITY_ASSERT(mine.size() == num_rows * owned * num_components);
  return inBlock(mine, owned, num_rows, num_components, destinations_, numbers_, *domain_.comm);
}
} // namespace asperity::io
