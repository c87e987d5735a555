#pragma once

#include "base/Types.hpp"
#include "fem/detail/ElementBlocks.hpp"

#include <Tpetra_CrsMatrix.hpp>

namespace asperity::fem::detail
{
using LocalMatrix = CrsMatrix::local_matrix_device_type; // columns ascending in blocks of a node

// The number of q among the neighbours of p, which are ascending.
template <int Components>
KOKKOS_FUNCTION int placeOf(LocalMatrix const& matrix, int p, int q)
{
  auto const& graph = matrix.graph;
  const auto begin = graph.row_map(p * Components);
  int low = 0;
  int high = static_cast<int>((graph.row_map(p * Components + 1) - begin) / Components) - 1;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (graph.entries(begin + middle * Components) < q * Components) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

// Adds to the coupling of p with the neighbour of this number.
template <int Components>
KOKKOS_FUNCTION void addBlock(LocalMatrix const& matrix, int p, int place,
                              Block<Components> const& block, double factor)
{
  for (int i = 0; i < Components; ++i) {
    const auto first = matrix.graph.row_map(p * Components + i) + place * Components;
    for (int j = 0; j < Components; ++j) {
      matrix.values(first + j) += factor * block(i, j);
    }
  }
}
} // namespace asperity::fem::detail
