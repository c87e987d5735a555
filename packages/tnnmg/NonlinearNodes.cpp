#include "tnnmg/NonlinearNodes.hpp"

#include <algorithm>

namespace asperity::tnnmg
{
NonlinearNodes coupledNodes(int num_nodes, int block_size, std::vector<int> const& held)
{
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> dofs("asperity::tnnmg::dofs",
                                                                            num_nodes, block_size);
  auto const host = Kokkos::create_mirror_view(dofs);
  std::vector<int> free;
  for (int node = 0; node < num_nodes; ++node) {
    for (int k = 0; k < block_size; ++k) {
      host(node, k) = node * block_size + k;
    }
    auto const first = held.begin() + node * block_size;
    if (std::find(first, first + block_size, 0) != first + block_size) {
      free.push_back(node);
    }
  }
  Kokkos::deep_copy(dofs, host);
  return {dofs,
          toDevice(held, "asperity::tnnmg::held"),
          {toDevice(free, "asperity::tnnmg::colour")},
          true};
}
} // namespace asperity::tnnmg
