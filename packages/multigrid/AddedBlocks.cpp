#include "multigrid/AddedBlocks.hpp"

#include "multigrid/NodeKernels.hpp"

#include <type_traits>

namespace asperity::multigrid
{
namespace
{
using Products = Kokkos::View<int* [3], Kokkos::LayoutRight, MemorySpace>;

// A coupling and its mirror image, whose sum is the transpose, so that couplings of different nodes
// stay mirror images to the last bit. Of Q_J^T H Q_K and its transpose the first one in the order
// of Q is computed, on every rank.
template <int T, int N>
struct AddProducts
{
  IndexView couplings, mirrored, first;
  Kokkos::View<const int* [3], Kokkos::LayoutRight, MemorySpace> products;
  float const* Q;
  double const* H;
  float* A;

  KOKKOS_FUNCTION void operator()(int i) const
  {
    Block in_order, transposed;
    for (int p = first(i); p < first(i + 1); ++p) {
      double const* h = H + static_cast<std::size_t>(products(p, 0)) * T * T;
      const int J = products(p, 1), K = products(p, 2);
      if (J <= K) {
        in_order.add(h, Q + static_cast<std::size_t>(J) * T * N,
                     Q + static_cast<std::size_t>(K) * T * N);
      } else {
        transposed.add(h, Q + static_cast<std::size_t>(K) * T * N,
                       Q + static_cast<std::size_t>(J) * T * N);
      }
    }
    float* to = A + static_cast<std::size_t>(couplings(i)) * N * N;
    float* mirror = mirrored(i) < 0 ? to : A + static_cast<std::size_t>(mirrored(i)) * N * N;
    for (int r = 0; r < N; ++r) {
      for (int c = 0; c < N; ++c) {
        const float sum = in_order.sum[r * N + c] + transposed.sum[c * N + r];
        to[r * N + c] += sum;
        if (mirror != to) {
          mirror[c * N + r] += sum;
        }
      }
    }
  }

  struct Block
  {
    float sum[N * N + 4] = {}; // for loads of four
    // += Q_J^T h Q_K
    KOKKOS_FUNCTION void add(double const* h, float const* QJ, float const* QK)
    {
      for (int r = 0; r < N; ++r) {
        float column[T] = {}; // of h Q_J
        for (int s = 0; s < T; ++s) {
          for (int t = 0; t < T; ++t) {
            column[s] += static_cast<float>(h[s * T + t]) * QJ[t * N + r];
          }
        }
        addTransposed<T, N>(QK, column, sum + r * N);
      }
    }
  };
};

// Calls work(T, N) with compile-time constants: 1 to 3 tangents, and the numbers of rigid body
// motions of withBlockSizes().
template <class Work>
void withSizes(int T, int N, Work const& work)
{
  const auto withTangents = [&](auto tangents) {
    withBlockSizes(N, N, [&](auto motions, auto) { work(tangents, motions); });
  };
  switch (T) {
  case 1: return withTangents(std::integral_constant<int, 1>());
  case 2: return withTangents(std::integral_constant<int, 2>());
  default: return withTangents(std::integral_constant<int, 3>());
  }
}

HessianView collected(std::vector<double> const& blocks, int T)
{
  const int num_nodes = static_cast<int>(blocks.size()) / (T * T);
  const HessianView result("asperity::multigrid::collected", num_nodes, T, T);
  const Kokkos::View<const double***, Kokkos::LayoutRight, Kokkos::HostSpace,
                     Kokkos::MemoryUnmanaged>
    from(blocks.data(), num_nodes, T, T);
  Kokkos::deep_copy(result, from);
  return result;
}
} // namespace

AddedBlocks::AddedBlocks(HostAddedBlocks const& host, HostGraph const& level,
                         std::vector<int> const& order)
    : tangents_(host.graph.row_size)
    , motions_(host.graph.column_size)
    , Q_(onDevice(host.Q))
    , rows_(indices(host.rows))
    , collect_(host.collect)
{
  std::vector<int> place(level.numCouplings(), -1), couplings, mirrored;
  for (int row : host.rows) {
    for (int k = level.first[row]; k < level.first[row + 1]; ++k) {
      const int column = level.columns[k];
      const int mirror = column < level.num_rows && column != row ? level.find(column, row) : -1;
      if (mirror < 0 || row < column) {
        place[k] = static_cast<int>(couplings.size());
        couplings.push_back(order[k]);
        mirrored.push_back(mirror < 0 ? -1 : order[mirror]);
      }
    }
  }
  // Calls work(node, J, K, place) for each product.
  const auto forEachProduct = [&](auto const& work) {
    for (int node = 0; node < host.graph.num_rows; ++node) {
      const int begin = host.graph.first[node], count = host.graph.first[node + 1] - begin;
      for (int pair = 0; pair < count * count; ++pair) {
        const int k = host.couplings[host.first[node] + pair];
        if (k >= 0 && place[k] >= 0) {
          work(node, begin + pair / count, begin + pair % count, place[k]);
        }
      }
    }
  };
  std::vector<int> first(couplings.size() + 1, 0);
  forEachProduct([&](int, int, int, int coupling) { ++first[coupling + 1]; });
  for (std::size_t i = 0; i < couplings.size(); ++i) {
    first[i + 1] += first[i];
  }
  const Products products("asperity::multigrid::products", first.back());
  const auto on_host = Kokkos::create_mirror_view(products);
  auto next = first;
  forEachProduct([&](int node, int J, int K, int coupling) {
    const int p = next[coupling]++;
    on_host(p, 0) = node;
    on_host(p, 1) = J;
    on_host(p, 2) = K;
  });
  Kokkos::deep_copy(products, on_host);
  products_ = products;
  couplings_ = indices(couplings);
  mirrored_ = indices(mirrored);
  first_product_ = indices(first);
}

void AddedBlocks::addTo(NodeBlocks const& A, HessianView const& H) const
{
  auto all = H;
  if (collect_) {
    const auto mine = toHost(H);
    all = collected(collect_({mine.data(), mine.data() + mine.size()}), tangents_);
  }
  if (couplings_.extent(0) == 0) {
    return;
  }
  withSizes(tangents_, motions_, [&](auto tangents, auto motions) {
    constexpr int T = decltype(tangents)::value, N = decltype(motions)::value;
    Kokkos::parallel_for("asperity::multigrid::addProducts",
                         RangePolicy(0, couplings_.extent_int(0)),
                         AddProducts<T, N>{couplings_, mirrored_, first_product_, products_,
                                           Q_.data(), all.data(), A.data()});
  });
}
} // namespace asperity::multigrid
