#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace asperity
{
// The numbers 0 <= i < size in disjoint sets, each of its own at first (union-find). Each set has a
// representative, which is one of its members.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size) : parent_(size)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }

  // The representative of the set of i.
  std::size_t find(std::size_t i)
  {
    while (parent_[i] != i) {
      i = parent_[i] = parent_[parent_[i]];
    }
    return i;
  }
  // Makes one set of the sets of i and j, with the representative of that of j.
  void join(std::size_t i, std::size_t j) { parent_[find(i)] = find(j); }

private:
  std::vector<std::size_t> parent_;
};
} // namespace asperity
