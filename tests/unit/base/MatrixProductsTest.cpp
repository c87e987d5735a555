#include "base/MatrixProducts.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_OrdinalTraits.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace asperity;

// Rows of one to four entries. All ranks but the last have ghosts.
class MatrixProducts : public ::testing::Test
{
protected:
  MatrixProducts()
  {
    const auto ranks = rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
    rows = rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), 40, 0, ranks));
    const GlobalOrdinal last = rows->getMaxAllGlobalIndex();
    const auto own = rcp(new CrsGraph(rows, 4));
    for (GlobalOrdinal row = rows->getMinGlobalIndex(); row <= rows->getMaxGlobalIndex(); ++row) {
      for (GlobalOrdinal k = 0; k <= row % 4; ++k) {
        const GlobalOrdinal column = std::min(row + 7 * k, last);
        own->insertGlobalIndices(row, 1, &column);
      }
    }
    own->fillComplete();
    graph = own;
  }

  RCP<const CrsMatrix> matrix(unsigned seed) const
  {
    const auto result = rcp(new CrsMatrix(graph));
    Vector scale(rows);
    result->setAllToScalar(1.25);
    result->fillComplete();
    randomise(scale, seed);
    result->leftScale(scale);
    return result;
  }
  static void randomise(Vector& x, unsigned seed)
  {
    const auto values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < values.extent(0); ++i) {
      values(i, 0) = std::sin(1. + static_cast<double>(i * seed));
    }
  }
  static void expectProduct(MatrixProduct const& product, Vector const& owned_x)
  {
    Vector expected(product.y.getMap());
    product.A.apply(owned_x, expected);
    const double size = expected.norm2();
    expected.update(-1, product.y, 1);
    EXPECT_LE(expected.norm2(), 1e-14 * size); // unlike a maximum, this is nan if a value is
    EXPECT_GT(size, 0);
  }

  RCP<const Map> rows;
  RCP<const CrsGraph> graph;
};

// In one pass (one rank) and one by one (more ranks, or a graph of its own).
TEST_F(MatrixProducts, TakenTogetherAreThoseTakenAlone)
{
  const auto A = matrix(1), B = matrix(2), C = matrix(3);
  const CrsMatrix of_own_graph(*B, Teuchos::Copy);
  Vector u(rows), v(rows), y0(rows), y1(rows), y2(rows), y3(rows);
  randomise(u, 4);
  randomise(v, 5);
  for (auto const* second : {B.get(), &of_own_graph}) {
    const std::vector<MatrixProduct> products = {
      {*A, u, y0}, {*second, v, y1}, {*C, u, y2}, {*C, v, y3}};
    for (std::size_t count = 1; count <= products.size(); ++count) {
      for (std::size_t k = 0; k < count; ++k) {
        products[k].y.putScalar(std::nan(""));
      }
      multiply({products.begin(), products.begin() + count});
      for (std::size_t k = 0; k < count; ++k) {
        expectProduct(products[k], products[k].x);
      }
    }
  }
}

TEST_F(MatrixProducts, TakeVectorsWithGhosts)
{
  const auto A = matrix(1);
  Vector u(rows), y(rows), with_ghosts(A->getColMap());
  randomise(u, 4);
  with_ghosts.doImport(u, Import(rows, A->getColMap()), Tpetra::INSERT);
  multiply({{*A, with_ghosts, y}});
  expectProduct({*A, with_ghosts, y}, u);
}
} // namespace
