#pragma once

#include "multigrid/smoothers/SweepRows.hpp"

// The damping of sweeps. Between chunks of rows and between ranks Gauss-Seidel is Jacobi, which
// grows where these are strongly coupled, as nearly incompressible rock is: the cycle is then not
// positive, and conjugate gradients fail. Sweeps that solve with D + E in place of the blocks D on
// the diagonal are a positive preconditioner if D + 2 E - G is positive, where G has the couplings
// with other chunks and ranks (Baker, Falgout, Kolev & Yang 2011, l1 smoothers).
namespace asperity::multigrid
{
// 1 / sqrt(D_cc) of a row's components, zero where it is held or has no energy.
template <int N>
struct ScaleRow
{
  int const* diagonal; // of MatrixGraph
  float const* A;
  int const* held; // (rows), or null
  float* scale;    // (columns with ghosts)
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    for (int c = 0; c < N; ++c) {
      const float own =
        diagonal[row] < 0 ? 0 : A[(static_cast<std::size_t>(diagonal[row]) * N + c) * N + c];
      const bool is_free = own > 0 && (held == nullptr || held[row * N + c] == 0);
      scale[row * N + c] = is_free ? 1 / math::sqrt(own) : 0;
    }
  }
};

// The least E of a row for which, in the scale of D's diagonal, the smallest eigenvalue of
// (t - 1) D and t E are together at least the sum of |G| over each row, t = `largest`: then
// t (D + E) - (D + G) is positive semidefinite, and the eigenvalues of (D + E)^-1 (D + G) are at
// most t. The eigenvalue is bounded by the largest row sum of the inverse. With Gauss-Seidel most
// rows have E = 0.
template <int N>
struct DampRow
{
  BlockRows<N> matrix;
  int const* diagonal;
  float const* scale; // with ghosts
  float* E;
  double largest; // above 1
  KOKKOS_FUNCTION void operator()(int row, int begin, int end) const
  {
    double outside[N] = {};
    for (int k = matrix.lower[row]; k < matrix.firstWithin(begin, row); ++k) {
      addCoupling(row, k, outside);
    }
    for (int k = matrix.upper[row + 1]; k > matrix.upper[row] && matrix.columns[k - 1] >= end;
         --k) {
      addCoupling(row, k - 1, outside);
    }
    const double least = smallestEigenvalue(row);
    for (int c = 0; c < N; ++c) {
      const float own = scale[row * N + c];
      const double excess = own > 0 ? outside[c] - (largest - 1) * least : 0;
      E[row * N + c] = excess > 0 ? static_cast<float>(excess / (largest * own * own)) : 0;
    }
  }

private:
  KOKKOS_FUNCTION void addCoupling(int row, int k, double (&outside)[N]) const
  {
    float const* block = matrix.A + static_cast<std::size_t>(k) * N * N;
    for (int c = 0; c < N; ++c) {
      for (int d = 0; d < N; ++d) {
        outside[c] += math::fabs(block[c * N + d]) * scale[row * N + c] *
                      scale[static_cast<std::size_t>(matrix.columns[k]) * N + d];
      }
    }
  }
  // A lower bound for the scaled block of a row with itself.
  KOKKOS_FUNCTION double smallestEigenvalue(int row) const
  {
    double block[N][N] = {};
    for (int c = 0; c < N && diagonal[row] >= 0; ++c) {
      for (int d = 0; d < N; ++d) {
        block[c][d] = matrix.A[(static_cast<std::size_t>(diagonal[row]) * N + c) * N + d] *
                      scale[row * N + c] * scale[row * N + d];
      }
    }
    float inverse[N * N];
    invertFree(block, AllFree(), inverse);
    double most = 0;
    for (int c = 0; c < N; ++c) {
      double sum = 0;
      for (int d = 0; d < N; ++d) {
        sum += math::fabs(inverse[c * N + d]);
      }
      most = sum > most ? sum : most;
    }
    return most > 0 ? 1 / most : 0;
  }
};
} // namespace asperity::multigrid
