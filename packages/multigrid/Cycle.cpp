#include "multigrid/Cycle.hpp"

#include "multigrid/CoarsestSolver.hpp"
#include "multigrid/CycleKernels.hpp"
#include "multigrid/FlushDenormals.hpp"

#include <stdexcept>
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

// The first numbers of `to` become those of `from`.
void copyFirst(NodeVector const& from, NodeVector const& to, std::size_t count)
{
  const auto first = std::make_pair(std::size_t(0), count);
  Kokkos::deep_copy(Kokkos::subview(to, first), Kokkos::subview(from, first));
}

float const* pointerTo(NodeVector const& x) { return x.extent(0) > 0 ? x.data() : nullptr; }

template <class Row>
void forEachOf(IndexView const& rows, Row const& row)
{
  Kokkos::parallel_for("asperity::multigrid::someRows", RangePolicy(0, rows.extent_int(0)),
                       AtRows<Row>{rows, row});
}
} // namespace

Cycle::LevelData::LevelData(Level const& level, SumOverRanks sum)
    : matrix{level,         {}, {}, makeNumbers(level.graph.rows() * level.graph.row_size), {},
             std::move(sum)}
    , x(makeNumbers(level.graph.columnsWithGhosts()))
    , residual(makeNumbers(level.graph.rows()))
    , coarse(makeNumbers(level.prolongation.columnsWithGhosts()))
{
}

Cycle::Cycle(std::shared_ptr<const Hierarchy> hierarchy, std::vector<double> const& weights,
             HostBlocks const& Z, std::vector<char> const& held, Dofs const& added,
             std::string const& smoother)
    : hierarchy_(std::move(hierarchy))
    , weights_(weights)
{
  if (weights_.size() > most_terms) {
    throw std::invalid_argument("multigrid: Z is the sum of " + std::to_string(weights_.size()) +
                                " terms, but a cycle has room for " + std::to_string(most_terms) +
                                ". Raise Cycle::most_terms.");
  }
  auto const& levels = hierarchy_->levels();
  auto const& kind = SmootherRegistry::instance().at(smoother);
  for (auto const& level : levels) {
    data_.emplace_back(level, hierarchy_->coarsest().sum);
    if (data_.size() < levels.size()) {
      data_.back().smoother = kind.make();
    }
  }
  auto& finest_matrix = data_[0].matrix;
  finest_matrix.held = FlagView("asperity::multigrid::held", held.size());
  const int size = rowSize();
  const IndexView given = indices({held.begin(), held.end()});
  const Kokkos::View<int**, Kokkos::LayoutRight, MemorySpace> rows(
    "asperity::multigrid::added", added.extent(0), added.extent(1));
  withNumbers(hierarchy_->rowOfNode(), size, [&](auto numbers) {
    using Numbers = decltype(numbers);
    Kokkos::parallel_for("asperity::multigrid::held", RangePolicy(0, given.extent_int(0)),
                         CopyFlags<Numbers>{numbers, given, finest_matrix.held});
    Kokkos::parallel_for("asperity::multigrid::added", RangePolicy(0, rows.extent_int(0)),
                         CopyDofs<Numbers>{numbers, added, rows});
  });
  added_ = rows;
  finest_matrix.A = hierarchy_->inOrder(Z);
  own_ = makeNumbers(added.extent(0) * size * size);
  damp(0);
  withSize(size, [&](auto rows_of_block) {
    constexpr int N = decltype(rows_of_block)::value;
    Kokkos::parallel_for(
      "asperity::multigrid::keep", RangePolicy(0, added_.extent_int(0)),
      KeepBlock<N>{finest().graph.diagonal.data(), added_, finest_matrix.A.data(), own_.data()});
    finest().schedule.forEach(finestInversion<N>());
  });
  for (std::size_t l = 1; l < levels.size(); ++l) {
    auto const& graph = levels[l].graph;
    data_[l].matrix.A =
      makeNumbers(static_cast<std::size_t>(graph.numCouplings()) * graph.blockSize());
    data_[l].b = makeNumbers(graph.rows());
    levels[l].schedule.forEach(sumOfTerms(l));
    damp(l);
    withSize(graph.row_size, [&](auto rows_of_block) {
      levels[l].schedule.forEach(inversion<decltype(rows_of_block)::value>(l));
    });
  }
  for (auto const& data : data_) {
    if (data.smoother) {
      data.smoother->matrixChanged(data.matrix);
    }
  }
}

Cycle::~Cycle() = default;

SumTermsRow Cycle::sumOfTerms(std::size_t l) const
{
  auto const& level = hierarchy_->levels()[l];
  auto const& graph = level.graph;
  SumTermsRow result = {{},
                        graph.lower.data(),
                        graph.diagonal.data(),
                        graph.upper.data(),
                        graph.blockSize(),
                        data_[l].matrix.A.data()};
  result.weighted.count = static_cast<int>(weights_.size());
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    result.weighted.terms[k] = level.terms[k].data();
    result.weighted.weights[k] = weights_[k];
  }
  return result;
}

template <int N>
InvertRow<N> Cycle::inversion(std::size_t l) const
{
  auto const& level = hierarchy_->levels()[l];
  auto const& matrix = data_[l].matrix;
  return {level.graph.diagonal.data(), matrix.A.data(), pointerTo(matrix.damping),
          matrix.inverse.data()};
}

// Brings the damping of a level up to date with its matrix. Collective.
void Cycle::damp(std::size_t l)
{
  auto& data = data_[l];
  if (data.smoother) {
    data.smoother->damp(data.matrix);
  }
}

void Cycle::clearHeld(std::size_t l, NodeVector const& x) const
{
  auto const& matrix = data_[l].matrix;
  withSize(matrix.blockSize(), [&](auto rows) {
    matrix.level.schedule.forEach(
      ClearHeldRow<decltype(rows)::value>{matrix.inverse.data(), x.data()});
  });
}

bool Cycle::setup(HessianView const& H, ConstFlagView const& removed)
{
  auto const& data = data_[0];
  withSize(rowSize(), [&](auto rows) {
    constexpr int N = decltype(rows)::value;
    Kokkos::parallel_for(
      "asperity::multigrid::invertAdded", RangePolicy(0, added_.extent_int(0)),
      InvertAdded<N>{finestInversion<N>(), added_, H, removed, own_.data(), data.matrix.A.data()});
  });
  if (isCoarsest(0)) {
    return factorise(data.matrix.A);
  }
  data.smoother->addedBlocksChanged(data.matrix);
  return coarsest_ || factorise(data_.back().matrix.A);
}

template <int N>
InvertFinest<N> Cycle::finestInversion() const
{
  auto const& matrix = data_[0].matrix;
  return {finest().graph.diagonal.data(), matrix.A.data(), pointerTo(matrix.damping),
          matrix.held.data(), matrix.inverse.data()};
}

// A: the matrix of the coarsest level.
bool Cycle::factorise(NodeBlocks const& A)
{
  auto const& graph = hierarchy_->levels().back().graph;
  const auto inverse = toHost(data_.back().matrix.inverse);
  std::vector<char> free;
  for (std::size_t i = 0; i < graph.rows(); ++i) {
    const std::size_t row = i / graph.row_size, c = i % graph.row_size;
    free.push_back(inverse((row * graph.row_size + c) * graph.row_size + c) != 0);
  }
  coarsest_ = CoarsestSolver::make(graph, hierarchy_->coarsest(), A, std::move(free));
  return coarsest_ != nullptr;
}

void Cycle::setCoarseBlocks(HessianView const& H)
{
  for (std::size_t l = 1; l < data_.size(); ++l) {
    auto const& level = hierarchy_->levels()[l];
    forEachOf(level.added.rows(), sumOfTerms(l));
    auto const& data = data_[l];
    level.added.addTo(data.matrix.A, H);
    damp(l);
    withSize(level.graph.row_size, [&](auto rows) {
      constexpr int N = decltype(rows)::value;
      if (data.matrix.damping.extent(0) > 0) {
        level.schedule.forEach(inversion<N>(l));
      } else {
        forEachOf(level.added.rows(), inversion<N>(l));
      }
    });
    if (data.smoother) {
      data.smoother->matrixChanged(data.matrix);
    }
  }
  coarsest_.reset();
}

void Cycle::descend(std::size_t l, NodeVector const& b)
{
  auto const& level = hierarchy_->levels()[l];
  auto& data = data_[l];
  if (isCoarsest(l)) {
    coarsest_->solve(b, data.x);
    return;
  }
  data.smoother->presmooth(data.matrix, b, data.x, data.residual);
  clearHeld(l, data.residual);
  level.restriction.multiply(level.prolongation, level.schedule, level.P, data.residual,
                             data.coarse, data.parts);
  level.prolongation.gather(data.coarse);
  auto const& next = data_[l + 1];
  copyFirst(data.coarse, next.b, next.b.extent(0));
  descend(l + 1, next.b);
  copyFirst(next.x, data.coarse, next.b.extent(0));
  level.prolongation.share(data.coarse);
  multiplyAdd(level.prolongation, level.schedule, level.P, data.coarse, data.x);
  clearHeld(l, data.x);
  data.smoother->postsmooth(data.matrix, b, data.x, data.residual);
}

Cycle::Result Cycle::run(NodeVector const& r, bool with_image)
{
  const FlushDenormals flushed;
  auto const& data = data_[0];
  descend(0, r);
  if (with_image) {
    if (isCoarsest(0)) { // solved exactly
      Kokkos::deep_copy(data.residual, r);
    } else {
      data.smoother->image(data.matrix, data.x, data.residual);
    }
    clearHeld(0, data.residual);
  }
  return {data.x, data.residual};
}

void Cycle::toRows(ConstNodeView const& given, double by, NodeVector const& x) const
{
  withNumbers(hierarchy_->rowOfNode(), rowSize(), [&](auto numbers) {
    schedule().forEachNumber(rowSize(), ToRows<decltype(numbers)>{numbers, given, by, x.data()});
  });
}

void Cycle::fromRows(NodeVector const& x, double times, NodeView const& result) const
{
  withNumbers(hierarchy_->rowOfNode(), rowSize(), [&](auto numbers) {
    schedule().forEachNumber(rowSize(),
                             FromRows<decltype(numbers)>{numbers, x.data(), times, result});
  });
}

std::size_t Cycle::bytes() const
{
  std::size_t sum = sizeof(float) * own_.extent(0);
  for (auto const& data : data_) {
    auto const& matrix = data.matrix;
    sum += sizeof(float) *
           (matrix.A.extent(0) + matrix.inverse.extent(0) + matrix.damping.extent(0) +
            data.b.extent(0) + data.x.extent(0) + data.residual.extent(0) + data.coarse.extent(0));
    sum += data.smoother ? data.smoother->bytes() : 0;
  }
  return sum;
}
} // namespace asperity::multigrid
