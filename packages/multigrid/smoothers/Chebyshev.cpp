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

// d = again d + step D^-1 r, and x += d unless x is null.
template <int N>
struct StepRow
{
  float const *inverse, *r;
  float again, step;
  float *d, *x;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    float rest[N], z[N];
    for (int c = 0; c < N; ++c) {
      rest[c] = r[row * N + c];
    }
    multiplySymmetric<N>(inverse + static_cast<std::size_t>(row) * N * N, rest, z);
    for (int i = row * N; i < (row + 1) * N; ++i) {
      d[i] = (again != 0 ? again * d[i] : 0) + step * z[i - row * N];
      if (x != nullptr) {
        x[i] += d[i];
      }
    }
  }
};

// Of a symmetric tridiagonal matrix, by bisection: a number is above all eigenvalues if all pivots
// of the matrix less that number are negative.
double largestEigenvalue(std::vector<double> const& diagonal, std::vector<double> const& beside)
{
  const auto isAboveAll = [&](double number) {
    double pivot = diagonal[0] - number;
    for (std::size_t i = 1; i < diagonal.size() && pivot < 0; ++i) {
      pivot = diagonal[i] - number - beside[i - 1] * beside[i - 1] / pivot;
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

// Polynomials in D^-1 A that are Chebyshev's of the fourth kind (Lottes 2023, Numer. Linear Algebra
// Appl. 30, e2518): of all of their degree they give the best bound for a V-cycle, and need only the
// largest eigenvalue. With degree k they change an error by a factor of less than 1 between zero and
// that eigenvalue, and beyond, for k = 2 until 1.25 times it.
class Chebyshev final : public Smoother
{
public:
  static constexpr char const* meaning =
    "a polynomial of degree 2 in the inverse blocks times the matrix, before and after, the same "
    "in any order of rows; it estimates the largest eigenvalue of each level.";

  void matrixChanged(LevelMatrix const& matrix) override
  {
    if (d_.extent(0) == 0) {
      d_ = makeNumbers(matrix.level.graph.columnsWithGhosts());
    }
    // An estimate is from below. The mean of all eigenvalues is 1.
    largest_ = std::max(1., margin * estimate(matrix));
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
  static constexpr int most_steps = 10; // of an estimate
  static constexpr double margin = 1.1;

  void step(LevelMatrix const& matrix, int k, NodeVector const& r, NodeVector const& x) const
  {
    const double again = k == 1 ? 0 : (2. * k - 3) / (2. * k + 1);
    const double factor = (8. * k - 4) / ((2. * k + 1) * largest_);
    solveBlocks(matrix, r, again, factor, d_, x.data());
  }

  static void solveBlocks(LevelMatrix const& matrix, NodeVector const& r, double again,
                          double factor, NodeVector const& d, float* x)
  {
    withBlockSizes(matrix.blockSize(), matrix.blockSize(), [&](auto size, auto) {
      constexpr int N = decltype(size)::value;
      matrix.level.schedule.forEach(StepRow<N>{matrix.inverse.data(), r.data(),
                                               static_cast<float>(again),
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

  // The largest eigenvalue of the tridiagonal matrix of a few steps of conjugate gradients for
  // D^-1 A (Lanczos); the steps begin with the same vector on any number of ranks if the nodes'
  // ids are the same.
  double estimate(LevelMatrix const& matrix) const
  {
    auto const& schedule = matrix.level.schedule;
    const int N = matrix.blockSize();
    const std::size_t rows = matrix.level.graph.rows();
    const auto r = makeNumbers(rows), z = makeNumbers(rows), w = makeNumbers(rows);
    auto const& p = d_;
    Kokkos::deep_copy(p, 0.f);
    schedule.forEachNumber(N, FillRandom{matrix.level.ids, N, r.data()});
    std::vector<double> diagonal, beside;
    double rz = 0, again = 0, length = 0;
    for (int k = 0; k < most_steps; ++k) {
      solveBlocks(matrix, r, 0, 1, z, nullptr);
      const double rz_before = rz, length_before = length;
      rz = product(matrix, r, z);
      again = k == 0 ? 0 : rz / rz_before;
      schedule.forEachNumber(N, AddToScaled{static_cast<float>(again), z.data(), p.data()});
      Kokkos::deep_copy(w, 0.f);
      matrix.level.graph.share(p);
      multiplyAdd(matrix.level.graph, schedule, matrix.A, p, w);
      const double curvature = product(matrix, p, w);
      if (!(rz > 0 && curvature > 0)) { // no free row, or an indefinite matrix, which is refused
        break;
      }
      length = rz / curvature;
      diagonal.push_back(1 / length + (k == 0 ? 0 : again / length_before));
      if (k > 0) {
        beside.push_back(std::sqrt(again) / length_before);
      }
      schedule.forEachNumber(N, AddScaled{static_cast<float>(-length), w.data(), r.data()});
    }
    return diagonal.empty() ? 0 : largestEigenvalue(diagonal, beside);
  }

  double largest_ = 1; // eigenvalue of D^-1 A
  NodeVector d_;       // the last change of x, with ghosts
};
} // namespace

ASPERITY_REGISTER(SmootherRegistry, "Chebyshev", SmootherKindOf<Chebyshev>)
} // namespace asperity::multigrid
