#include "multigrid/Cycle.hpp"

#include "multigrid/CoarsestSolver.hpp"
#include "multigrid/CycleKernels.hpp"
#include "multigrid/Damping.hpp"
#include "multigrid/FlushDenormals.hpp"
#include "multigrid/Sweeps.hpp"

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

NodeVector copyOf(NodeVector const& from)
{
  const auto result = makeNumbers(from.extent(0));
  Kokkos::deep_copy(result, from);
  return result;
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

Cycle::LevelData::LevelData(Level const& level)
    : inverse(makeNumbers(level.graph.rows() * level.graph.row_size))
    , x(makeNumbers(level.graph.columnsWithGhosts()))
    , residual(makeNumbers(level.graph.rows()))
    , coarse(makeNumbers(level.prolongation.columnsWithGhosts()))
{
}

Cycle::Cycle(std::shared_ptr<const Hierarchy> hierarchy, std::vector<double> const& weights,
             HostBlocks const& Z, std::vector<char> const& held, Dofs const& added)
    : hierarchy_(std::move(hierarchy))
    , weights_(weights)
    , held_("asperity::multigrid::held", held.size())
{
  auto const& levels = hierarchy_->levels();
  for (auto const& level : levels) {
    data_.emplace_back(level);
  }
  const int size = rowSize();
  const IndexView given = indices({held.begin(), held.end()});
  const Kokkos::View<int**, Kokkos::LayoutRight, MemorySpace> rows(
    "asperity::multigrid::added", added.extent(0), added.extent(1));
  withNumbers(hierarchy_->rowOfNode(), size, [&](auto numbers) {
    using Numbers = decltype(numbers);
    Kokkos::parallel_for("asperity::multigrid::held", RangePolicy(0, given.extent_int(0)),
                         CopyFlags<Numbers>{numbers, given, held_});
    Kokkos::parallel_for("asperity::multigrid::added", RangePolicy(0, rows.extent_int(0)),
                         CopyDofs<Numbers>{numbers, added, rows});
  });
  added_ = rows;
  data_[0].A = hierarchy_->inOrder(Z);
  withSize(size, [&](auto rows_of_block) {
    constexpr int N = decltype(rows_of_block)::value;
    damp<N>(0);
    finest().schedule.forEach(finestInversion<N>());
  });
  for (std::size_t l = 1; l < levels.size(); ++l) {
    auto const& graph = levels[l].graph;
    data_[l].A = makeNumbers(static_cast<std::size_t>(graph.numCouplings()) * graph.blockSize());
    data_[l].b = makeNumbers(graph.rows());
    levels[l].schedule.forEach(sumOfTerms(l));
    withSize(graph.row_size, [&](auto rows_of_block) {
      constexpr int N = decltype(rows_of_block)::value;
      damp<N>(l);
      levels[l].schedule.forEach(inversion<N>(l));
    });
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
                        data_[l].A.data()};
  result.of.count = static_cast<int>(weights_.size());
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    result.of.terms[k] = level.terms[k].data();
    result.of.weights[k] = weights_[k];
  }
  return result;
}

template <int N>
InvertRow<N> Cycle::inversion(std::size_t l) const
{
  auto const& level = hierarchy_->levels()[l];
  auto const& data = data_[l];
  return {level.graph.diagonal.data(), data.A.data(), pointerTo(data.damping), data.inverse.data()};
}

// Brings the damping of a level up to date with its matrix. Collective.
template <int N>
void Cycle::damp(std::size_t l)
{
  auto const& level = hierarchy_->levels()[l];
  auto& data = data_[l];
  if (isCoarsest(l) || !level.hasJacobiPart()) {
    return;
  }
  if (data.damping.extent(0) == 0) {
    data.damping = makeNumbers(level.graph.rows());
  }
  int const* held = l == 0 ? held_.data() : nullptr;
  int const* diagonal = level.graph.diagonal.data();
  auto const& scale = data.x; // which a cycle overwrites
  level.schedule.forEach(ScaleRow<N>{diagonal, data.A.data(), held, scale.data()});
  level.graph.share(scale);
  level.schedule.forEach(DampRow<N>{BlockRows<N>(level, data.A, data.inverse, data.damping),
                                    diagonal, scale.data(), data.damping.data()});
}

bool Cycle::setup(HessianView const& H, ConstFlagView const& removed)
{
  NodeBlocks with_added;
  if (isCoarsest(0)) {
    with_added = copyOf(data_[0].A);
  }
  withSize(rowSize(), [&](auto rows) {
    constexpr int N = decltype(rows)::value;
    Kokkos::parallel_for("asperity::multigrid::invertAdded", RangePolicy(0, added_.extent_int(0)),
                         InvertAdded<N>{finestInversion<N>(), added_, H, removed,
                                        isCoarsest(0) ? with_added.data() : nullptr});
  });
  if (isCoarsest(0)) {
    return factorise(with_added);
  }
  return coarsest_ || factorise(data_.back().A);
}

template <int N>
InvertFinest<N> Cycle::finestInversion() const
{
  auto const& data = data_[0];
  return {finest().graph.diagonal.data(), data.A.data(), pointerTo(data.damping), held_.data(),
          data.inverse.data()};
}

// A: the matrix of the coarsest level.
bool Cycle::factorise(NodeBlocks const& A)
{
  auto const& graph = hierarchy_->levels().back().graph;
  const auto inverse = toHost(data_.back().inverse);
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
    level.added.addTo(data_[l].A, H);
    withSize(level.graph.row_size, [&](auto rows) {
      constexpr int N = decltype(rows)::value;
      damp<N>(l);
      if (data_[l].damping.extent(0) > 0) {
        level.schedule.forEach(inversion<N>(l));
      } else {
        forEachOf(level.added.rows(), inversion<N>(l));
      }
    });
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
  withSize(level.graph.row_size, [&](auto rows) {
    const Sweeps<decltype(rows)::value> sweeps(level, data.A, data.inverse, data.damping);
    sweeps.forward(b, data.x, data.residual);
    sweeps.clearHeld(data.residual);
    level.restriction.multiply(level.prolongation, level.schedule, level.P, data.residual,
                               data.coarse, data.parts);
    level.prolongation.gather(data.coarse);
    auto const& next = data_[l + 1];
    copyFirst(data.coarse, next.b, next.b.extent(0));
    descend(l + 1, next.b);
    copyFirst(next.x, data.coarse, next.b.extent(0));
    level.prolongation.share(data.coarse);
    multiplyAdd(level.prolongation, level.schedule, level.P, data.coarse, data.x);
    sweeps.clearHeld(data.x);
    sweeps.backward(b, data.x, data.residual, data.before);
  });
}

Cycle::Result Cycle::run(NodeVector const& r, bool with_image)
{
  const FlushDenormals flushed;
  auto const& data = data_[0];
  descend(0, r);
  if (with_image) {
    withSize(rowSize(), [&](auto rows) {
      const Sweeps<decltype(rows)::value> sweeps(finest(), data.A, data.inverse, data.damping);
      if (isCoarsest(0)) { // solved exactly
        Kokkos::deep_copy(data.residual, r);
        sweeps.clearHeld(data.residual);
      } else {
        sweeps.image(data.x, data.residual);
      }
    });
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
  std::size_t sum = 0;
  for (auto const& data : data_) {
    sum += sizeof(float) * (data.A.extent(0) + data.inverse.extent(0) + data.damping.extent(0) +
                            data.b.extent(0) + data.x.extent(0) + data.residual.extent(0) +
                            data.coarse.extent(0) + data.before.extent(0));
  }
  return sum;
}
} // namespace asperity::multigrid
