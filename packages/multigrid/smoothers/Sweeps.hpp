#pragma once

#include "multigrid/smoothers/Damping.hpp"
#include "multigrid/smoothers/SweepRows.hpp"

namespace asperity::multigrid
{
// Block sweeps with D + E, forward before and backward after the coarse correction. From zero the
// forward sweep and the residual together read A once, and the product with the result follows from
// data that the backward sweep reads.
template <template <class> class Order>
class SweepSmoother : public Smoother
{
public:
  // largest: what the eigenvalues of (D + E)^-1 (D + G) may reach (DampRow), below 2 to be smooth.
  explicit SweepSmoother(double largest) : largest_(largest) {}

  void damp(LevelMatrix& matrix) override
  {
    auto const& level = matrix.level;
    if (!is_jacobi && !level.hasJacobiPart()) {
      return;
    }
    if (matrix.damping.extent(0) == 0) {
      matrix.damping = makeNumbers(level.graph.rows());
    }
    const auto scale = makeNumbers(level.graph.columnsWithGhosts());
    withBlockSize(matrix, [&](auto rows) {
      constexpr int N = decltype(rows)::value;
      int const* held = matrix.held.extent(0) > 0 ? matrix.held.data() : nullptr;
      int const* diagonal = level.graph.diagonal.data();
      level.schedule.forEach(ScaleRow<N>{diagonal, matrix.A.data(), held, scale.data()});
      level.graph.share(scale);
      level.schedule.forEach(Order<DampRow<N>>{
        {BlockRows<N>(matrix), diagonal, scale.data(), matrix.damping.data(), largest_}});
    });
  }

  void presmooth(LevelMatrix const& matrix, NodeVector const& b, NodeVector const& x,
                 NodeVector const& residual) override
  {
    auto const& level = matrix.level;
    withBlockSize(matrix, [&](auto size) {
      constexpr int N = decltype(size)::value;
      const BlockRows<N> rows(matrix);
      level.schedule.forward(Order<ForwardRow<N>>{{rows, b.data(), x.data()}});
      level.graph.share(x);
      level.schedule.forEach(Order<ResidualRow<N>>{{rows, x.data(), residual.data()}});
    });
  }

  // Stores b - (L + G) x_before + E (x_before - x) in `residual`.
  void postsmooth(LevelMatrix const& matrix, NodeVector const& b, NodeVector const& x,
                  NodeVector const& residual) override
  {
    auto const& level = matrix.level;
    level.graph.share(x);
    const bool keeps_before = is_jacobi || level.schedule.sharesSweeps();
    if (keeps_before) {
      if (before_.extent(0) == 0) {
        before_ = makeNumbers(x.extent(0));
      }
      Kokkos::deep_copy(before_, x);
    }
    auto const& x_before = keeps_before ? before_ : x;
    withBlockSize(matrix, [&](auto size) {
      constexpr int N = decltype(size)::value;
      level.schedule.backward(Order<BackwardRow<N>>{
        {BlockRows<N>(matrix), b.data(), x_before.data(), x.data(), residual.data()}});
    });
  }

  void image(LevelMatrix const& matrix, NodeVector const& x, NodeVector const& image) override
  {
    matrix.level.graph.share(x);
    withBlockSize(matrix, [&](auto size) {
      constexpr int N = decltype(size)::value;
      matrix.level.schedule.forEach(
        Order<ImageRow<N>>{{BlockRows<N>(matrix), x.data(), image.data()}});
    });
  }

  std::size_t bytes() const override { return sizeof(float) * before_.extent(0); }

private:
  static constexpr bool is_jacobi = Order<ForwardRow<1>>::is_jacobi;

  template <class Work>
  static void withBlockSize(LevelMatrix const& matrix, Work const& work)
  {
    withBlockSizes(matrix.blockSize(), matrix.blockSize(), [&](auto rows, auto) { work(rows); });
  }

  double largest_;
  NodeVector before_; // x before a backward sweep, if that needs it
};
} // namespace asperity::multigrid
