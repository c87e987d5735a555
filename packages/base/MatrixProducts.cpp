#include "base/MatrixProducts.hpp"

#include "base/Errors.hpp"
#include "base/Views.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity
{
namespace
{
using Graph = CrsMatrix::local_matrix_device_type::StaticCrsGraphType;

Graph graphOf(CrsMatrix const& A) { return A.getLocalMatrixDevice().graph; }

// The same on all ranks, also on those that have no ghosts.
bool lacksGhosts(MatrixProduct const& product)
{
  auto const graph = product.A.getCrsGraph();
  return !graph->getExporter().is_null() ||
         (!graph->getImporter().is_null() && product.x.getMap() != graph->getColMap());
}

template <int N>
struct MultiplyRow
{
  Graph graph;
  int num_rows;
  Kokkos::Array<const double*, N> values, x;
  Kokkos::Array<double*, N> y;

  KOKKOS_FUNCTION void operator()(int row) const
  {
    if (row + rows_ahead < num_rows) {
      fetch(row + rows_ahead);
    }
    double sums[N] = {};
    for (auto k = graph.row_map(row); k < graph.row_map(row + 1); ++k) {
      const int column = graph.entries(k);
      for (int n = 0; n < N; ++n) {
        sums[n] += values[n][k] * x[n][column];
      }
    }
    for (int n = 0; n < N; ++n) {
      y[n][row] = sums[n];
    }
  }

  // The values of a row are fetched into the cache of the host this number of rows before they are
  // used: rows are too short for a processor to do it by itself.
  static constexpr int rows_ahead = 12;

  KOKKOS_FUNCTION void fetch([[maybe_unused]] int row) const
  {
#if !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__) && !defined(__SYCL_DEVICE_ONLY__)
    constexpr int numbers_of_a_line = 8; // 64 bytes
    for (auto k = graph.row_map(row); k < graph.row_map(row + 1); k += numbers_of_a_line) {
      for (int n = 0; n < N; ++n) {
        __builtin_prefetch(values[n] + k);
      }
    }
#endif
  }
};

template <int N>
void multiplyInOnePass(std::vector<MatrixProduct> const& products)
{
  auto const graph = graphOf(products.front().A);
  MultiplyRow<N> rows{graph, static_cast<int>(graph.numRows()), {}, {}, {}};
  for (int n = 0; n < N; ++n) {
    auto const& product = products[n];
    rows.values[n] = product.A.getLocalMatrixDevice().values.data();
    rows.x[n] = product.x.getLocalViewDevice(Tpetra::Access::ReadOnly).data();
    rows.y[n] = product.y.getLocalViewDevice(Tpetra::Access::OverwriteAll).data();
  }
  Kokkos::parallel_for("asperity::base::multiply", RangePolicy(0, rows.num_rows), rows);
}
} // namespace

void multiply(std::vector<MatrixProduct> const& products)
{
  auto const* const entries = graphOf(products.front().A).entries.data();
  std::vector<MatrixProduct> together;
  for (auto const& product : products) {
    if (lacksGhosts(product)) {
      product.A.apply(product.x, product.y);
    } else if (graphOf(product.A).entries.data() == entries) {
      together.push_back(product);
    } else {
      multiplyInOnePass<1>({product});
    }
  }
  switch (together.size()) {
  case 0: break;
  case 1: return multiplyInOnePass<1>(together);
  case 2: return multiplyInOnePass<2>(together);
  case 3: return multiplyInOnePass<3>(together);
  case 4: return multiplyInOnePass<4>(together);
  default: ASPERITY_ASSERT(false);
  }
}
} // namespace asperity
