#include "multigrid/Hierarchy.hpp"

#include <algorithm>
#include <stdexcept>

namespace asperity::multigrid
{
namespace
{
// Adds Q_J^T H Q_K and, if J is not K, its transpose: one product for both keeps the sum symmetric.
template <int T, int N>
void addNode(AddedBlocks const& added, int node, double const* H, NodeBlocks& A)
{
  const int begin = added.graph.first[node];
  const int count = added.graph.first[node + 1] - begin;
  for (int j = 0; j < count; ++j) {
    float const* QJ = &added.Q[static_cast<std::size_t>(begin + j) * T * N];
    double HQ[T][N]; // H Q_J
    for (int s = 0; s < T; ++s) {
      for (int c = 0; c < N; ++c) {
        HQ[s][c] = 0;
        for (int t = 0; t < T; ++t) {
          HQ[s][c] += H[s * T + t] * QJ[t * N + c];
        }
      }
    }
    for (int k = j; k < count; ++k) {
      const int to = added.couplings[added.first[node] + j * count + k];
      const int back = k > j ? added.couplings[added.first[node] + k * count + j] : -1;
      if (to < 0 && back < 0) {
        continue;
      }
      float const* QK = &added.Q[static_cast<std::size_t>(begin + k) * T * N];
      for (int r = 0; r < N; ++r) {
        for (int c = 0; c < N; ++c) {
          double sum = 0;
          for (int s = 0; s < T; ++s) {
            sum += HQ[s][r] * QK[s * N + c];
          }
          if (to >= 0) {
            A[(static_cast<std::size_t>(to) * N + r) * N + c] += static_cast<float>(sum);
          }
          if (back >= 0) {
            A[(static_cast<std::size_t>(back) * N + c) * N + r] += static_cast<float>(sum);
          }
        }
      }
    }
  }
}

template <int T, int N>
void addAll(AddedBlocks const& added, std::vector<double> const& blocks, NodeBlocks& A)
{
  for (int node = 0; node < added.graph.num_rows; ++node) {
    double const* H = &blocks[static_cast<std::size_t>(node) * T * T];
    if (std::any_of(H, H + T * T, [](double entry) { return entry != 0; })) {
      addNode<T, N>(added, node, H, A);
    }
  }
}

template <int T>
void addWithSize(AddedBlocks const& added, std::vector<double> const& blocks, NodeBlocks& A)
{
  switch (added.graph.column_size) { // rigid body motions, as in withBlockSizes
  case 1: return addAll<T, 1>(added, blocks, A);
  case 2: return addAll<T, 2>(added, blocks, A);
  case 3: return addAll<T, 3>(added, blocks, A);
  case 4: return addAll<T, 4>(added, blocks, A);
  case 6: return addAll<T, 6>(added, blocks, A);
  default: throw std::logic_error("multigrid: no kernels for this number of rigid motions");
  }
}
} // namespace

void AddedBlocks::addTo(NodeBlocks& A, std::vector<double> const& H) const
{
  const auto all = collect ? collect(H) : H;
  if (graph.num_rows == 0) {
    return;
  }
  switch (graph.row_size) {
  case 1: return addWithSize<1>(*this, all, A);
  case 2: return addWithSize<2>(*this, all, A);
  default: return addWithSize<3>(*this, all, A);
  }
}

void Level::complete(int num_threads)
{
  chunks = Chunks(graph.first, num_threads);
  for (int row = 0; row < graph.num_rows; ++row) {
    int k = graph.first[row];
    while (k < graph.first[row + 1] && graph.columns[k] < row) {
      ++k;
    }
    before.push_back(k);
    after.push_back(k + (k < graph.first[row + 1] && graph.columns[k] == row ? 1 : 0));
  }
}
} // namespace asperity::multigrid
