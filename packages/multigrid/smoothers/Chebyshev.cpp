#include "multigrid/CycleKernels.hpp"
#include "multigrid/NodeKernels.hpp"
#include "multigrid/NodeMatrix.hpp"
#include "multigrid/Smoother.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity::multigrid
{
namespace
{
// A number in [-1, 1) that depends on `number` alone.
KOKKOS_INLINE_FUNCTION float pseudorandom(std::uint32_t number)
{
  number = (number ^ (number >> 16)) * 0x7feb352dU;
  number = (number ^ (number >> 15)) * 0x846ca68bU;
  number ^= number >> 16;
  return static_cast<float>(number >> 8) * (1.f / (1 << 23)) - 1.f;
}

struct FillRandom
{
  IndexView ids; // of the level's nodes
  int size;
  float* r;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    r[i] = pseudorandom(static_cast<std::uint32_t>(ids(i / size)) * 6U +
                        static_cast<std::uint32_t>(i % size));
  }
};

// y = x + factor y, or y += factor x
struct AddToScaled
{
  float factor;
  float const* x;
  float* y;
  KOKKOS_FUNCTION void operator()(int i) const { y[i] = x[i] + factor * y[i]; }
};
struct AddScaled
{
  float factor;
  float const* x;
  float* y;
  KOKKOS_FUNCTION void operator()(int i) const { y[i] += factor * x[i]; }
};

struct InnerProduct
{
  using value_type = double[]; // NOLINT(modernize-avoid-c-arrays): as Kokkos wants it
  unsigned value_count = 1;
  float const *x, *y;
  KOKKOS_FUNCTION void operator()(int i, double* sums) const
  {
    sums[0] += static_cast<double>(x[i]) * y[i];
  }
  void addRange(int begin, int end, double* sums) const
  {
    for (int i = begin; i < end; ++i) {
      (*this)(i, sums);
    }
  }
};

// d = beta d + step D^-1 r, and x += d unless x is null.
template <int N>
struct StepRow
{
  float const *inverse, *r;
  float beta, step;
  float *d, *x;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    float rest[N], z[N];
    for (int c = 0; c < N; ++c) {
      rest[c] = r[row * N + c];
    }
    multiplySymmetric<N>(inverse + static_cast<std::size_t>(row) * N * N, rest, z);
    for (int i = row * N; i < (row + 1) * N; ++i) {
      d[i] = (beta != 0 ? beta * d[i] : 0) + step * z[i - row * N];
      if (x != nullptr) {
        x[i] += d[i];
      }
    }
  }
};

// The largest eigenvalue of a symmetric tridiagonal matrix, by bisection: a number is above all
// eigenvalues if all pivots of the matrix less that number are negative.
double largestEigenvalue(std::vector<double> const& diagonal,
                         std::vector<double> const& off_diagonal)
{
  const auto isAboveAll = [&](double number) {
    double pivot = diagonal[0] - number;
    for (std::size_t i = 1; i < diagonal.size() && pivot < 0; ++i) {
      pivot = diagonal[i] - number - off_diagonal[i - 1] * off_diagonal[i - 1] / pivot;
    }
    return pivot < 0;
  };
  double below = *std::max_element(diagonal.begin(), diagonal.end());
  double above = 2 * below;
  while (!isAboveAll(above)) {
    above *= 2;
  }
  while (above - below > 1e-6 * above) {
    const double middle = (below + above) / 2;
    (isAboveAll(middle) ? above : below) = middle;
  }
  return above;
}

// The largest sum of a row of a block in the scale of its diagonal: (that sum) times the diagonal
// is at least the block. E = excess times that.
template <int N>
struct DampBlock
{
  int const* diagonal; // of MatrixGraph
  float const* A;
  double excess;
  float* E;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    float const* block = A + static_cast<std::size_t>(diagonal[row]) * N * N;
    double most = 0;
    for (int c = 0; c < N && diagonal[row] >= 0; ++c) {
      double sum = 0;
      for (int d = 0; d < N; ++d) {
        const double scale = math::sqrt(static_cast<double>(block[c * N + c]) * block[d * N + d]);
        sum += scale > 0 ? math::fabs(block[c * N + d]) / scale : 0;
      }
      most = sum > most ? sum : most;
    }
    for (int c = 0; c < N; ++c) {
      E[row * N + c] = diagonal[row] < 0 ? 0 : static_cast<float>(excess * most * block[c * N + c]);
    }
  }
};

// A polynomial in (D + E)^-1 A that is Chebyshev's of the fourth kind (Lottes 2023, Numer. Linear
// Algebra Appl. 30, e2518): of all of its degree it gives the best bound for a V-cycle, and needs
// only a bound for the eigenvalues. With degree 2 and the bound t it changes an error of eigenvalue
// l by the factor q = (4 c^2 + 2 c - 1) / 5, c = 1 - 2 l / t, which is between -1 and 1 for l up to
// 1.25 t.
//
// At a node with a stiff block H the eigenvalue is 1, and its error, which the coarse correction
// has left there, has to vanish, because its energy is large: q(1) = 0 for t = 2 / (1 - cos(2 pi /
// 5)) = 2.894. E makes t a bound: it is zero if the largest eigenvalue of D^-1 A, as estimated for
// the matrix without H, is less, and otherwise as much of D as is missing.
class Chebyshev final : public Smoother
{
public:
  static constexpr char const* meaning =
    "a polynomial of degree 2 in the inverse blocks times the matrix, before and after, the same "
    "in any order of rows; it estimates the largest eigenvalue of each level.";

  void damp(LevelMatrix& matrix) override
  {
    auto const& graph = matrix.level.graph;
    if (d_.extent(0) == 0) {
      d_ = makeNumbers(graph.columnsWithGhosts());
    }
    const double excess = margin * estimate(matrix) / bound - 1; // the same on all ranks
    if (!(excess > 0)) {
      Kokkos::deep_copy(matrix.damping, 0.f); // if there was any
      return;
    }
    if (matrix.damping.extent(0) == 0) {
      matrix.damping = makeNumbers(graph.rows());
    }
    withBlockSizes(matrix.blockSize(), matrix.blockSize(), [&](auto size, auto) {
      matrix.level.schedule.forEach(DampBlock<decltype(size)::value>{
        graph.diagonal.data(), matrix.A.data(), excess, matrix.damping.data()});
    });
  }

  void presmooth(LevelMatrix const& matrix, NodeVector const& b, NodeVector const& x,
                 NodeVector const& residual) override
  {
    Kokkos::deep_copy(x, 0.f);
    Kokkos::deep_copy(residual, b);
    for (int k = 1; k <= degree; ++k) {
      step(matrix, k, residual, x);
      subtractProduct(matrix, d_, residual);
    }
  }

  void postsmooth(LevelMatrix const& matrix, NodeVector const& b, NodeVector const& x,
                  NodeVector const& residual) override
  {
    Kokkos::deep_copy(residual, b);
    subtractProduct(matrix, x, residual);
    for (int k = 1; k <= degree; ++k) {
      step(matrix, k, residual, x);
      if (k < degree) {
        subtractProduct(matrix, d_, residual);
      }
    }
  }

  void image(LevelMatrix const& matrix, NodeVector const& x, NodeVector const& image) override
  {
    Kokkos::deep_copy(image, 0.f);
    matrix.level.graph.share(x);
    multiplyAdd(matrix.level.graph, matrix.level.schedule, matrix.A, x, image);
  }

  std::size_t bytes() const override { return sizeof(float) * d_.extent(0); }

private:
  static constexpr int degree = 2;
  static constexpr double bound = 2.8944271909999157; // t
  static constexpr int most_steps = 10;               // of an estimate
  static constexpr double margin = 1.1;               // an estimate is from below

  void step(LevelMatrix const& matrix, int k, NodeVector const& r, NodeVector const& x) const
  {
    const double beta = k == 1 ? 0 : (2. * k - 3) / (2. * k + 1);
    const double factor = (8. * k - 4) / ((2. * k + 1) * bound);
    solveBlocks(matrix, matrix.inverse, r, beta, factor, d_, x.data());
  }

  static void solveBlocks(LevelMatrix const& matrix, NodeBlocks const& inverse, NodeVector const& r,
                          double beta, double factor, NodeVector const& d, float* x)
  {
    withBlockSizes(matrix.blockSize(), matrix.blockSize(), [&](auto size, auto) {
      constexpr int N = decltype(size)::value;
      matrix.level.schedule.forEach(StepRow<N>{inverse.data(), r.data(), static_cast<float>(beta),
                                               static_cast<float>(factor), d.data(), x});
    });
  }

  // r -= A x
  static void subtractProduct(LevelMatrix const& matrix, NodeVector const& x, NodeVector const& r)
  {
    matrix.level.graph.share(x);
    multiplyAdd(matrix.level.graph, matrix.level.schedule, matrix.A, x, r, -1);
  }

  static double product(LevelMatrix const& matrix, NodeVector const& x, NodeVector const& y)
  {
    double sum =
      matrix.level.schedule.sum<1>(matrix.blockSize(), InnerProduct{1, x.data(), y.data()})[0];
    matrix.sum(&sum, 1);
    return sum;
  }

  static NodeBlocks undampedInverse(LevelMatrix const& matrix)
  {
    auto const& graph = matrix.level.graph;
    const auto inverse = makeNumbers(graph.rows() * graph.row_size);
    withBlockSizes(graph.row_size, graph.row_size, [&](auto size, auto) {
      constexpr int N = decltype(size)::value;
      int const* diagonal = graph.diagonal.data();
      if (matrix.held.extent(0) > 0) {
        matrix.level.schedule.forEach(
          InvertFinest<N>{diagonal, matrix.A.data(), nullptr, matrix.held.data(), inverse.data()});
      } else {
        matrix.level.schedule.forEach(
          InvertRow<N>{diagonal, matrix.A.data(), nullptr, inverse.data()});
      }
    });
    return inverse;
  }

  // The largest eigenvalue of the tridiagonal matrix of a few steps of conjugate gradients for
  // D^-1 A (Lanczos); the steps begin with the same vector on any number of ranks if the nodes'
  // ids are the same.
  double estimate(LevelMatrix const& matrix) const
  {
    auto const& schedule = matrix.level.schedule;
    const int N = matrix.blockSize();
    const std::size_t rows = matrix.level.graph.rows();
    const auto r = makeNumbers(rows), z = makeNumbers(rows), w = makeNumbers(rows);
    const auto inverse = undampedInverse(matrix);
    auto const& p = d_;
    Kokkos::deep_copy(p, 0.f);
    schedule.forEachNumber(N, FillRandom{matrix.level.ids, N, r.data()});
    std::vector<double> diagonal, off_diagonal;
    double rz = 0, beta = 0, length = 0;
    for (int k = 0; k < most_steps; ++k) {
      solveBlocks(matrix, inverse, r, 0, 1, z, nullptr);
      const double rz_before = rz, length_before = length;
      rz = product(matrix, r, z);
      beta = k == 0 ? 0 : rz / rz_before;
      schedule.forEachNumber(N, AddToScaled{static_cast<float>(beta), z.data(), p.data()});
      Kokkos::deep_copy(w, 0.f);
      matrix.level.graph.share(p);
      multiplyAdd(matrix.level.graph, schedule, matrix.A, p, w);
      const double curvature = product(matrix, p, w);
      if (!(rz > 0 && curvature > 0)) { // no free row, or an indefinite matrix, which is refused
        break;
      }
      length = rz / curvature;
      diagonal.push_back(1 / length + (k == 0 ? 0 : beta / length_before));
      if (k > 0) {
        off_diagonal.push_back(std::sqrt(beta) / length_before);
      }
      schedule.forEachNumber(N, AddScaled{static_cast<float>(-length), w.data(), r.data()});
    }
    return diagonal.empty() ? 0 : largestEigenvalue(diagonal, off_diagonal);
  }

  NodeVector d_; // the last change of x, with ghosts
};
} // namespace

ASPERITY_REGISTER(SmootherRegistry, "Chebyshev", SmootherKindOf<Chebyshev>)
} // namespace asperity::multigrid
