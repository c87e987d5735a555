#include "catalogue/receivers/ElementTree.hpp"

#include <cmath>
#include <numeric>

namespace asperity::catalogue
{
ElementTree::ElementTree(io::OutputDomain const& domain) : dimension_(domain.dimension)
{
  const std::size_t per_element = static_cast<std::size_t>(domain.nodes_per_element) * dimension_;
  for (std::size_t element = 0; element < domain.numOwnedElements(); ++element) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (std::size_t i = 0; i < per_element; ++i) {
      const double x = domain.corners[element * per_element + i];
      double &low = box.low[i % dimension_], &high = box.high[i % dimension_];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    boxes_.push_back(box);
  }
  order_.resize(boxes_.size());
  std::iota(order_.begin(), order_.end(), std::size_t(0));
  if (!order_.empty()) {
    grow(0, order_.size());
  }
}

// Splits the elements into halves along the longest side of the box around them, by the middles of
// their own boxes.
void ElementTree::grow(std::size_t first, std::size_t last)
{
  constexpr std::size_t most_in_leaf = 8;
  Box box = boxes_[order_[first]];
  for (std::size_t i = first; i < last; ++i) {
    for (int d = 0; d < dimension_; ++d) {
      box.low[d] = std::min(box.low[d], boxes_[order_[i]].low[d]);
      box.high[d] = std::max(box.high[d], boxes_[order_[i]].high[d]);
    }
  }
  const std::size_t number = nodes_.size();
  nodes_.push_back({box, first, last, 0});
  if (last - first <= most_in_leaf) {
    return;
  }
  int axis = 0;
  for (int d = 1; d < dimension_; ++d) {
    axis = box.high[d] - box.low[d] > box.high[axis] - box.low[axis] ? d : axis;
  }
  const auto middle = [this, axis](std::size_t element) {
    return boxes_[element].low[axis] + boxes_[element].high[axis];
  };
  const std::size_t half = first + (last - first) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [&middle](std::size_t left, std::size_t right) {
    return middle(left) < middle(right);
  });
  grow(first, half);
  nodes_[number].second_branch = nodes_.size();
  grow(half, last);
}

double ElementTree::distance(Box const& box, double const* point) const
{
  double square = 0;
  for (int d = 0; d < dimension_; ++d) {
    const double outside = std::max({box.low[d] - point[d], point[d] - box.high[d], 0.});
    square += outside * outside;
  }
  return std::sqrt(square);
}
} // namespace asperity::catalogue
