#include "tnnmg/NonlinearNodes.hpp"

#include <algorithm>
#include <string>

namespace asperity::tnnmg
{
namespace
{
template <class T>
Kokkos::View<const T*, MemorySpace> toDevice(std::vector<T> const& values, char const* label)
{
  Kokkos::View<T*, MemorySpace> view(std::string(label), values.size());
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) {
    host(i) = values[i];
  }
  Kokkos::deep_copy(view, host);
  return view;
}

NonlinearDofView toDevice(std::vector<std::vector<int>> const& values, int block_size,
                          char const* label)
{
  Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> view(std::string(label),
                                                                      values.size(), block_size);
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t node = 0; node < values.size(); ++node) {
    for (int k = 0; k < block_size; ++k) {
      host(node, k) = values[node][k];
    }
  }
  Kokkos::deep_copy(view, host);
  return view;
}

bool isFree(std::vector<int> const& fixed)
{
  return std::find(fixed.begin(), fixed.end(), 0) != fixed.end();
}
} // namespace

NonlinearNodes nonlinearNodes(CrsMatrix const& Z, std::vector<std::vector<int>> const& dofs,
                              int block_size, std::vector<std::vector<int>> const& fixed)
{
  auto const views = toDevice(dofs, block_size, "asperity::tnnmg::dofs");
  auto const colouring = colourNodes(Z, views);
  NonlinearNodes nodes;
  nodes.dofs = views;
  nodes.fixed = toDevice(fixed, block_size, "asperity::tnnmg::fixed");
  for (auto const& rows : colouring.rows) {
    std::vector<int> free;
    for (int row : rows) {
      if (isFree(fixed[row])) {
        free.push_back(row);
      }
    }
    nodes.colours.push_back(toDevice(free, "asperity::tnnmg::colour"));
  }
  return nodes;
}

NonlinearNodes coupledNodes(int num_nodes, int block_size,
                            std::vector<std::vector<int>> const& fixed)
{
  std::vector<std::vector<int>> dofs(num_nodes);
  for (int node = 0; node < num_nodes; ++node) {
    for (int k = 0; k < block_size; ++k) {
      dofs[node].push_back(node * block_size + k);
    }
  }
  NonlinearNodes nodes;
  nodes.dofs = toDevice(dofs, block_size, "asperity::tnnmg::dofs");
  nodes.fixed = toDevice(fixed, block_size, "asperity::tnnmg::fixed");
  for (int node = 0; node < num_nodes; ++node) {
    if (isFree(fixed[node])) {
      nodes.colours.push_back(toDevice(std::vector<int>{node}, "asperity::tnnmg::colour"));
    }
  }
  return nodes;
}
} // namespace asperity::tnnmg
