#include "fem/MatrixProducts.hpp"

#include "base/Errors.hpp"
#include "base/Views.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::fem
{
namespace
{
using Graph = CrsMatrix::local_matrix_device_type::StaticCrsGraphType;

Graph graphOf(CrsMatrix const& A) { return A.getLocalMatrixDevice().graph; }

bool hasNoGhosts(CrsMatrix const& A)
{
  auto const graph = A.getCrsGraph();
  return graph->getImporter().is_null() && graph->getExporter().is_null();
}

template <int N>
struct Rows
{
  Graph graph;
  Kokkos::Array<const double*, N> values, x;
  Kokkos::Array<double*, N> y;

  KOKKOS_FUNCTION void operator()(int row) const
  {
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
};

template <int N>
void multiplyInOnePass(std::vector<MatrixProduct> const& products)
{
  Rows<N> rows{graphOf(products.front().A), {}, {}, {}};
  for (int n = 0; n < N; ++n) {
    auto const& product = products[n];
    rows.values[n] = product.A.getLocalMatrixDevice().values.data();
    rows.x[n] = product.x.getLocalViewDevice(Tpetra::Access::ReadOnly).data();
    rows.y[n] = product.y.getLocalViewDevice(Tpetra::Access::OverwriteAll).data();
  }
  Kokkos::parallel_for("asperity::fem::multiply", RangePolicy(0, rows.graph.numRows()), rows);
}
} // namespace

void multiply(std::vector<MatrixProduct> const& products)
{
  auto const* const entries = graphOf(products.front().A).entries.data();
  std::vector<MatrixProduct> together;
  for (auto const& product : products) {
    if (!hasNoGhosts(product.A)) {
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
} // namespace asperity::fem
