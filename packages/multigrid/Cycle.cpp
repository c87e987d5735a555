#include "multigrid/Cycle.hpp"

#include "multigrid/CoarsestSolver.hpp"
#include "multigrid/FlushDenormals.hpp"
#include "multigrid/Sweeps.hpp"

#include <algorithm>
#include <utility>

namespace asperity::multigrid
{
namespace
{
template <class Work>
void withSize(int size, Work const& work)
{
  withBlockSizes(size, size, [&](auto rows, auto) { work(rows); });
}
} // namespace

Cycle::LevelData::LevelData(Level const& level)
    : A(static_cast<std::size_t>(level.graph.numCouplings()) * level.graph.blockSize())
    , inverse(level.graph.rows() * level.graph.row_size)
    , b(level.graph.rows())
    , x(level.graph.columnsWithGhosts())
    , residual(level.graph.rows())
    , coarse(level.prolongation.columnsWithGhosts())
{
}

Cycle::Cycle(std::shared_ptr<const Hierarchy> hierarchy, std::vector<double> weights, NodeBlocks Z,
             std::vector<char> held, HostView<const int**> added)
    : hierarchy_(std::move(hierarchy))
    , weights_(std::move(weights))
    , added_(std::move(added))
    , held_(std::move(held))
{
  auto const& levels = hierarchy_->levels;
  for (auto const& level : levels) {
    data_.emplace_back(level);
  }
  data_[0].A = std::move(Z);
  data_[0].b = {};
  levels[0].chunks.forEachRow([&](int row) { invertFinest(row, nullptr, nullptr); });
  for (std::size_t l = 1; l < levels.size(); ++l) {
    levels[l].chunks.forEachRow([&](int row) {
      sumTerms(l, row);
      invert(l, row);
    });
  }
}

Cycle::~Cycle() = default;

// A row of the level's matrix, without added blocks.
void Cycle::sumTerms(std::size_t l, int row)
{
  auto const& level = hierarchy_->levels[l];
  const auto size = static_cast<std::size_t>(level.graph.blockSize());
  for (auto i = level.graph.first[row] * size; i < level.graph.first[row + 1] * size; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < weights_.size(); ++k) {
      sum += weights_[k] * level.terms[k][i];
    }
    data_[l].A[i] = static_cast<float>(sum);
  }
}

void Cycle::invert(std::size_t l, int row)
{
  auto const& level = hierarchy_->levels[l];
  auto& data = data_[l];
  withSize(level.graph.row_size, [&](auto rows) {
    constexpr int N = decltype(rows)::value;
    double block[N][N] = {};
    if (level.after[row] > level.before[row]) {
      std::copy_n(&data.A[static_cast<std::size_t>(level.before[row]) * N * N], N * N,
                  &block[0][0]);
    }
    invertFree(
      block, [](int) { return true; }, &data.inverse[static_cast<std::size_t>(row) * N * N]);
  });
}

// H(N, N) is added to the block of Z; both may be null.
void Cycle::invertFinest(int row, double const* H, bool const* removed)
{
  auto const& level = hierarchy_->levels[0];
  auto& data = data_[0];
  withSize(level.graph.row_size, [&](auto rows) {
    constexpr int N = decltype(rows)::value;
    double block[N][N];
    std::copy_n(&data.A[static_cast<std::size_t>(level.before[row]) * N * N], N * N, &block[0][0]);
    for (int i = 0; H != nullptr && i < N * N; ++i) {
      block[i / N][i % N] += H[i];
    }
    const auto free = [&](int c) {
      return !held_[row * N + c] && (removed == nullptr || !removed[c]);
    };
    invertFree(block, free, &data.inverse[static_cast<std::size_t>(row) * N * N]);
  });
}

bool Cycle::setup(HostView<const double***> const& H, HostView<const int*> const& removed)
{
  auto const& level = hierarchy_->levels[0];
  const int size = level.graph.row_size;
  NodeBlocks with_added;
  if (isCoarsest(0)) {
    with_added = data_[0].A;
  }
  for (int node = 0; node < added_.extent_int(0); ++node) {
    const int row = added_(node, 0) / size;
    double block[9] = {};
    bool is_removed[3] = {};
    for (int s = 0; s < added_.extent_int(1); ++s) {
      const int component = added_(node, s) % size;
      is_removed[component] = removed(node) != 0;
      for (int t = 0; t < added_.extent_int(1); ++t) {
        block[component * size + added_(node, t) % size] = H(node, s, t);
      }
    }
    invertFinest(row, block, is_removed);
    for (int i = 0; isCoarsest(0) && i < size * size; ++i) {
      with_added[static_cast<std::size_t>(level.before[row]) * size * size + i] +=
        static_cast<float>(block[i]);
    }
  }
  if (isCoarsest(0)) {
    return factorise(with_added);
  }
  return coarsest_ || factorise(data_.back().A);
}

// A: the matrix of the coarsest level.
bool Cycle::factorise(NodeBlocks const& A)
{
  auto const& graph = hierarchy_->levels.back().graph;
  std::vector<char> free;
  for (std::size_t i = 0; i < graph.rows(); ++i) {
    const std::size_t row = i / graph.row_size, c = i % graph.row_size;
    free.push_back(data_.back().inverse[(row * graph.row_size + c) * graph.row_size + c] != 0);
  }
  coarsest_ = CoarsestSolver::make(graph, hierarchy_->coarsest, A, std::move(free));
  return coarsest_ != nullptr;
}

void Cycle::setCoarseBlocks(std::vector<double> const& H)
{
  for (std::size_t l = 1; l < data_.size(); ++l) {
    auto const& added = hierarchy_->levels[l].added;
    for (int row : added.rows) {
      sumTerms(l, row);
    }
    added.addTo(data_[l].A, H);
    for (int row : added.rows) {
      invert(l, row);
    }
  }
  coarsest_.reset();
}

void Cycle::descend(std::size_t l, NodeVector const& b)
{
  auto const& level = hierarchy_->levels[l];
  auto& data = data_[l];
  if (isCoarsest(l)) {
    coarsest_->solve(b, data.x);
    return;
  }
  withSize(level.graph.row_size, [&](auto rows) {
    const Sweeps<decltype(rows)::value> sweeps(level, data.A, data.inverse);
    sweeps.forward(b, data.x, data.residual);
    sweeps.clearHeld(data.residual);
    multiplyTransposed(level.prolongation, level.chunks, level.P, data.residual, data.coarse,
                       data.parts);
    level.prolongation.gather(data.coarse);
    auto& next = data_[l + 1];
    std::copy_n(data.coarse.begin(), next.b.size(), next.b.begin());
    descend(l + 1, next.b);
    std::copy_n(next.x.begin(), next.b.size(), data.coarse.begin());
    level.prolongation.share(data.coarse);
    multiplyAdd(level.prolongation, level.chunks, level.P, data.coarse, data.x);
    sweeps.clearHeld(data.x);
    sweeps.backward(b, data.x, data.residual, data.before);
  });
}

Cycle::Result Cycle::run(NodeVector const& r, bool with_image)
{
  const FlushDenormals flushed;
  auto& data = data_[0];
  descend(0, r);
  if (with_image) {
    auto const& level = hierarchy_->levels[0];
    withSize(level.graph.row_size, [&](auto rows) {
      const Sweeps<decltype(rows)::value> sweeps(level, data.A, data.inverse);
      if (isCoarsest(0)) { // solved exactly
        data.residual = r;
        sweeps.clearHeld(data.residual);
      } else {
        sweeps.image(data.x, data.residual);
      }
    });
  }
  return {data.x, data.residual};
}

std::size_t Cycle::bytes() const
{
  std::size_t sum = 0;
  for (auto const& data : data_) {
    sum += sizeof(float) * (data.A.size() + data.inverse.size() + data.b.size() + data.x.size() +
                            data.residual.size() + data.coarse.size() + data.before.size());
  }
  return sum;
}
} // namespace asperity::multigrid
