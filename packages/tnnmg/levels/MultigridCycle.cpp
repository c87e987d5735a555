#include "tnnmg/levels/MultigridCycle.hpp"

#include "base/program/WorkTimers.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/levels/CoarseFault.hpp"
#include "tnnmg/levels/FlushDenormals.hpp"
#include "tnnmg/levels/NodeKernels.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <algorithm>
#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
template <class Work>
void withSize(int size, Work const& work)
{
  withBlockSizes(size, size, [&](auto rows, auto) { work(rows); });
}

std::size_t numColumns(NodeGraph const& graph)
{
  return graph.column_map.is_null() ? static_cast<std::size_t>(graph.num_owned) * graph.column_size
                                    : numLocalElements(*graph.column_map);
}
} // namespace

MultigridCycle::Level::Level(MultigridLevel const& shared)
    : A(static_cast<std::size_t>(shared.graph.numCouplings()) * shared.graph.blockSize())
    , inverse(static_cast<std::size_t>(shared.graph.num_rows) * shared.graph.blockSize())
    , b(static_cast<std::size_t>(shared.graph.num_rows) * shared.graph.row_size)
    , x(numColumns(shared.graph))
    , residual(b.size())
    , ghosts(shared.graph)
{
  if (!shared.P.empty() || shared.prolongation.row_size > 0) {
    coarse.resize(numColumns(shared.prolongation));
    coarse_ghosts.emplace(shared.prolongation);
  }
}

MultigridCycle::MultigridCycle(std::shared_ptr<const MultigridFamily> family,
                               std::vector<double> weights, CrsMatrix const& Z,
                               std::shared_ptr<const MultigridNodes> nodes)
    : family_(std::move(family))
    , weights_(std::move(weights))
    , nodes_(std::move(nodes))
    , fault_(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), nodes_->view.dofs))
    , held_(numLocalRows(Z), 0)
{
  const auto held = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), nodes_->held_rows);
  for (int k = 0; k < held.extent_int(0); ++k) {
    held_[held(k)] = 1;
  }
  for (auto const& shared : family_->levels()) {
    levels_.emplace_back(shared);
  }
  levels_[0].A = blocksOf(family_->levels()[0].graph, Z);
  for (int row = 0; row < family_->levels()[0].graph.num_rows; ++row) {
    invertFine(row, nullptr, nullptr);
  }
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    for (int row = 0; row < family_->levels()[l].graph.num_rows; ++row) {
      sumTerms(l, row);
      invert(l, row);
    }
  }
}

// A row of the level's matrix, without Hessians.
void MultigridCycle::sumTerms(std::size_t l, int row)
{
  auto const& shared = family_->levels()[l];
  const auto size = static_cast<std::size_t>(shared.graph.blockSize());
  for (auto i = shared.graph.first[row] * size; i < shared.graph.first[row + 1] * size; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < weights_.size(); ++k) {
      sum += weights_[k] * shared.terms[k][i];
    }
    levels_[l].A[i] = static_cast<float>(sum);
  }
}

void MultigridCycle::invert(std::size_t l, int row)
{
  auto const& shared = family_->levels()[l];
  auto& level = levels_[l];
  withSize(shared.graph.row_size, [&](auto rows) {
    constexpr int N = decltype(rows)::value;
    double block[N][N] = {};
    if (shared.after[row] > shared.before[row]) {
      std::copy_n(&level.A[static_cast<std::size_t>(shared.before[row]) * N * N], N * N,
                  &block[0][0]);
    }
    detail::invertFree(
      block, [](int) { return true; }, &level.inverse[static_cast<std::size_t>(row) * N * N]);
  });
}

// hessian(N, N) is added to the block of Z; both may be null.
void MultigridCycle::invertFine(int row, double const* hessian, bool const* removed)
{
  auto const& shared = family_->levels()[0];
  auto& level = levels_[0];
  withSize(shared.graph.row_size, [&](auto rows) {
    constexpr int N = decltype(rows)::value;
    double block[N][N];
    std::copy_n(&level.A[static_cast<std::size_t>(shared.before[row]) * N * N], N * N,
                &block[0][0]);
    for (int i = 0; hessian != nullptr && i < N * N; ++i) {
      block[i / N][i % N] += hessian[i];
    }
    const auto free = [&](int c) {
      return !held_[row * N + c] && (removed == nullptr || !removed[c]);
    };
    detail::invertFree(block, free, &level.inverse[static_cast<std::size_t>(row) * N * N]);
  });
}

void MultigridCycle::setup()
{
  const auto H = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), nodes_->hessian);
  const auto flags = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), nodes_->removed);
  auto const& shared = family_->levels()[0];
  const int size = shared.graph.row_size;
  NodeBlocks with_hessians;
  if (isCoarsest(0)) {
    with_hessians = levels_[0].A;
  }
  for (int node = 0; node < fault_.extent_int(0); ++node) {
    const int row = fault_(node, 0) / size;
    double hessian[9] = {};
    bool removed[3] = {};
    for (int s = 0; s < fault_.extent_int(1); ++s) {
      const int component = fault_(node, s) % size;
      removed[component] = flags(node) != 0;
      for (int t = 0; t < fault_.extent_int(1); ++t) {
        hessian[component * size + fault_(node, t) % size] = H(node, s, t);
      }
    }
    invertFine(row, hessian, removed);
    for (int i = 0; isCoarsest(0) && i < size * size; ++i) {
      with_hessians[static_cast<std::size_t>(shared.before[row]) * size * size + i] +=
        static_cast<float>(hessian[i]);
    }
  }
  if (isCoarsest(0)) {
    factorise(with_hessians);
  } else if (!coarsest_) {
    factorise(levels_.back().A);
  }
}

// A: the matrix of the coarsest level.
void MultigridCycle::factorise(NodeBlocks const& A)
{
  auto const& graph = family_->levels().back().graph;
  std::vector<char> free;
  for (int i = 0; i < graph.num_rows * graph.row_size; ++i) {
    const std::size_t row = i / graph.row_size, c = i % graph.row_size;
    free.push_back(levels_.back().inverse[(row * graph.row_size + c) * graph.row_size + c] != 0);
  }
  coarsest_ = std::make_unique<CoarsestSolver>(graph, A, free);
}

void MultigridCycle::setCoarseHessians(std::vector<double> const& hessian)
{
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    auto const& fault = family_->levels()[l].fault;
    for (int row : fault.rows) {
      sumTerms(l, row);
    }
    if (!hessian.empty() || !fault.nodes.is_null()) {
      addHessians(fault, hessian, levels_[l].A);
    }
    for (int row : fault.rows) {
      invert(l, row);
    }
  }
  coarsest_.reset();
}

// The blocks of a row are fetched into the cache this number of rows before they are used. A sweep
// skips half of each row or goes backward, which the processor does not predict.
constexpr int rows_ahead = 8;

// Fetches the blocks first <= k < end of A into the cache.
template <int N>
void fetch(NodeBlocks const& A, int first, int end)
{
  constexpr std::size_t numbers_of_a_line = 16; // 64 bytes
  for (std::size_t i = static_cast<std::size_t>(first) * N * N;
       i < static_cast<std::size_t>(end) * N * N; i += numbers_of_a_line) {
    __builtin_prefetch(&A[i]);
  }
}

// The forward sweep from x = 0, and the residual after it.
template <int N>
void MultigridCycle::smoothForward(std::size_t l) const
{
  auto const& graph = family_->levels()[l].graph;
  auto const& shared = family_->levels()[l];
  auto const& level = levels_[l];
  std::fill(level.x.begin(), level.x.end(), 0.f);
  for (int row = 0; row < graph.num_rows; ++row) {
    if (const int next = row + rows_ahead; next < graph.num_rows) {
      fetch<N>(level.A, graph.first[next], shared.before[next]);
    }
    RowSums<N, N> before;
    for (int k = graph.first[row]; k < shared.before[row]; ++k) {
      before.add(&level.A[static_cast<std::size_t>(k) * N * N], &level.x[graph.columns[k] * N]);
    }
    float rest[N];
    for (int c = 0; c < N; ++c) {
      rest[c] = level.b[row * N + c] - before[c];
    }
    multiplySymmetric<N>(&level.inverse[static_cast<std::size_t>(row) * N * N], rest,
                         &level.x[row * N]);
  }
  level.ghosts.share(level.x);
  for (int row = 0; row < graph.num_rows; ++row) {
    if (const int next = row + rows_ahead; next < graph.num_rows) {
      fetch<N>(level.A, shared.after[next], graph.first[next + 1]);
    }
    RowSums<N, N> after;
    for (int k = shared.after[row]; k < graph.first[row + 1]; ++k) {
      after.add(&level.A[static_cast<std::size_t>(k) * N * N], &level.x[graph.columns[k] * N]);
    }
    for (int c = 0; c < N; ++c) {
      level.residual[row * N + c] = -after[c];
    }
  }
}

// Stores b - (L + G) x_before in `residual`, with the x before the sweep; L are the couplings with
// earlier nodes and G those with other ranks.
template <int N>
void MultigridCycle::smoothBackward(std::size_t l) const
{
  auto const& shared = family_->levels()[l];
  auto const& graph = shared.graph;
  auto const& level = levels_[l];
  level.ghosts.share(level.x);
  for (int row = graph.num_rows - 1; row >= 0; --row) {
    if (const int next = row - rows_ahead; next >= 0) {
      fetch<N>(level.A, graph.first[next], graph.first[next + 1]);
    }
    RowSums<N, N> old, updated;
    for (int k = graph.first[row]; k < shared.before[row]; ++k) {
      old.add(&level.A[static_cast<std::size_t>(k) * N * N], &level.x[graph.columns[k] * N]);
    }
    int k = shared.after[row];
    for (; k < graph.first[row + 1] && graph.columns[k] < graph.num_owned; ++k) {
      updated.add(&level.A[static_cast<std::size_t>(k) * N * N], &level.x[graph.columns[k] * N]);
    }
    for (; k < graph.first[row + 1]; ++k) {
      old.add(&level.A[static_cast<std::size_t>(k) * N * N], &level.x[graph.columns[k] * N]);
    }
    float rest[N];
    for (int c = 0; c < N; ++c) {
      level.residual[row * N + c] = level.b[row * N + c] - old[c];
      rest[c] = level.residual[row * N + c] - updated[c];
    }
    multiplySymmetric<N>(&level.inverse[static_cast<std::size_t>(row) * N * N], rest,
                         &level.x[row * N]);
  }
}

// (Z + H) x after the backward sweep, which solved (D + U) x = b - (L + G) x_before: only the
// couplings L + G have to be read.
template <int N>
void MultigridCycle::addImage() const
{
  auto const& shared = family_->levels()[0];
  auto const& graph = shared.graph;
  auto const& level = levels_[0];
  level.ghosts.share(level.x);
  for (int row = 0; row < graph.num_rows; ++row) {
    if (const int next = row + rows_ahead; next < graph.num_rows) {
      fetch<N>(level.A, graph.first[next], shared.before[next]);
    }
    RowSums<N, N> sum;
    for (int k = graph.first[row]; k < shared.before[row]; ++k) {
      sum.add(&level.A[static_cast<std::size_t>(k) * N * N], &level.x[graph.columns[k] * N]);
    }
    int k = graph.first[row + 1];
    for (; k > shared.after[row] && graph.columns[k - 1] >= graph.num_owned; --k) {
      sum.add(&level.A[static_cast<std::size_t>(k - 1) * N * N],
              &level.x[graph.columns[k - 1] * N]);
    }
    for (int c = 0; c < N; ++c) {
      level.residual[row * N + c] += sum[c];
    }
  }
  clearHeld<N>(level.residual, level);
}

// Sets the components that are not free to zero.
template <int N>
void MultigridCycle::clearHeld(NodeVector& x, Level const& level) const
{
  for (std::size_t row = 0; row * N * N < level.inverse.size(); ++row) {
    for (int c = 0; c < N; ++c) {
      if (level.inverse[row * N * N + c * N + c] == 0) {
        x[row * N + c] = 0;
      }
    }
  }
}

void MultigridCycle::cycle(std::size_t l) const
{
  auto const& shared = family_->levels()[l];
  auto const& level = levels_[l];
  if (isCoarsest(l)) {
    coarsest_->solve(level.b, level.x);
    return;
  }
  withSize(shared.graph.row_size, [&](auto rows) {
    constexpr int N = decltype(rows)::value;
    smoothForward<N>(l);
    clearHeld<N>(level.residual, level);
    multiplyTransposed(shared.prolongation, shared.P, level.residual, level.coarse);
    level.coarse_ghosts->gather(level.coarse);
    auto const& next = levels_[l + 1];
    std::copy_n(level.coarse.begin(), next.b.size(), next.b.begin());
    cycle(l + 1);
    std::copy_n(next.x.begin(), next.b.size(), level.coarse.begin());
    level.coarse_ghosts->share(level.coarse);
    multiplyAdd(shared.prolongation, shared.P, level.coarse, level.x);
    clearHeld<N>(level.x, level);
    smoothBackward<N>(l);
  });
}

void MultigridCycle::run(bool with_image) const
{
  ASPERITY_NAME_WORK("V-cycles");
  const FlushDenormals flushed;
  cycle(0);
  if (with_image) {
    withSize(family_->levels()[0].graph.row_size, [&](auto rows) {
      constexpr int N = decltype(rows)::value;
      if (isCoarsest(0)) { // solved exactly
        levels_[0].residual = levels_[0].b;
        clearHeld<N>(levels_[0].residual, levels_[0]);
      } else {
        addImage<N>();
      }
    });
  }
}

std::size_t MultigridCycle::bytes() const
{
  std::size_t sum = 0;
  for (auto const& level : levels_) {
    sum += 4 * (level.A.size() + level.inverse.size() + level.b.size() + level.x.size() +
                level.residual.size() + level.coarse.size());
  }
  return sum;
}
} // namespace asperity::tnnmg::detail
