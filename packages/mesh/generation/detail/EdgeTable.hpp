#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace asperity::mesh::detail
{
using Edge = std::array<int, 2>;

// Edges by their two vertices in any order, each with a number: a hash table with open addressing,
// since bisection looks up many edges and finds few.
class EdgeTable
{
public:
  bool empty() const { return size_ == 0; }

  void clear()
  {
    slots_.assign(first_capacity, Slot());
    size_ = 0;
  }

  // The number of an edge, or null if it is not in the table. The pointer is valid until the next
  // edge is added.
  int* find(Edge const& edge)
  {
    Slot& slot = slots_[place(keyOf(edge))];
    return slot.key == nothing ? nullptr : &slot.number;
  }

  // Returns false if the edge is in the table already; it then keeps its number.
  bool add(Edge const& edge, int number)
  {
    const std::uint64_t key = keyOf(edge);
    Slot& slot = slots_[place(key)];
    if (slot.key != nothing) {
      return false;
    }
    slot = {key, number};
    if (++size_ * 2 > slots_.size()) {
      grow();
    }
    return true;
  }

private:
  static constexpr std::uint64_t nothing = ~std::uint64_t(0);
  static constexpr std::size_t first_capacity = 1024; // a power of two, as all capacities
  struct Slot
  {
    std::uint64_t key = nothing;
    int number = 0;
  };

  static std::uint64_t keyOf(Edge const& edge)
  {
    const auto low = static_cast<std::uint64_t>(std::min(edge[0], edge[1]));
    return (low << 32) | static_cast<std::uint64_t>(std::max(edge[0], edge[1]));
  }

  // The slot of the key, or the empty slot for it.
  std::size_t place(std::uint64_t key) const
  {
    const std::uint64_t mixed = key * 0x9E3779B97F4A7C15u; // 2^64 / golden ratio
    std::size_t slot = (mixed ^ (mixed >> 32)) & (slots_.size() - 1);
    while (slots_[slot].key != nothing && slots_[slot].key != key) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }

  void grow()
  {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (Slot const& slot : old) {
      if (slot.key != nothing) {
        slots_[place(slot.key)] = slot;
      }
    }
  }

  std::vector<Slot> slots_ = std::vector<Slot>(first_capacity);
  std::size_t size_ = 0;
};
} // namespace asperity::mesh::detail
