#pragma once

#include "io/OutputDomain.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace asperity::catalogue
{
// The boxes around this rank's elements of a domain in a binary tree, so that the elements near a
// point are found in a time that grows with the logarithm of their number.
class ElementTree
{
public:
  explicit ElementTree(io::OutputDomain const& domain);

  // Calls visit(element), which returns a distance [m], for elements near the point, the likely
  // ones first, and leaves out those that are known to be farther away than the last distance
  // returned. The first distance is infinite.
  template <class Visit>
  void visitNear(double const* point, Visit const& visit) const
  {
    double bound = std::numeric_limits<double>::infinity();
    if (!nodes_.empty()) {
      visitBelow(0, point, bound, visit);
    }
  }

private:
  using Corner = std::array<double, 3>;
  struct Box
  {
    Corner low, high;
  };
  struct Node
  {
    Box box;
    std::size_t first, last;   // elements of a leaf, in order_
    std::size_t second_branch; // 0 for a leaf; the first branch is the next node
  };

  template <class Visit>
  void visitBelow(std::size_t number, double const* point, double& bound, Visit const& visit) const
  {
    Node const& node = nodes_[number];
    if (node.second_branch == 0) {
      for (std::size_t i = node.first; i < node.last; ++i) {
        if (distance(boxes_[order_[i]], point) <= bound) {
          bound = visit(order_[i]);
        }
      }
      return;
    }
    std::array<std::size_t, 2> branches = {number + 1, node.second_branch};
    std::array<double, 2> distances{};
    for (int i = 0; i < 2; ++i) {
      distances[i] = distance(nodes_[branches[i]].box, point);
    }
    const int nearer = distances[1] < distances[0] ? 1 : 0;
    for (const int i : {nearer, 1 - nearer}) {
      if (distances[i] <= bound) {
        visitBelow(branches[i], point, bound, visit);
      }
    }
  }

  void grow(std::size_t first, std::size_t last);
  double distance(Box const& box, double const* point) const;

  int dimension_;
  std::vector<Box> boxes_;         // (num_owned_elements)
  std::vector<std::size_t> order_; // the elements, those of a leaf together
  std::vector<Node> nodes_;        // the root first
};
} // namespace asperity::catalogue
