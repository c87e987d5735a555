#include "FaultState.hpp"
#include "base/Colouring.hpp"
#include "base/Errors.hpp"
#include "tnnmg/detail/CoarseCholesky.hpp"
#include "tnnmg/detail/MultigridPreconditioner.hpp"
#include "tnnmg/detail/MultigridSymmetry.hpp"

#include <Eigen/SparseCholesky>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <memory>

namespace asperity::tnnmg
{
using namespace testing;

namespace
{
// What MueLuCorrection makes of a model, in its parts.
struct Parts
{
  Parts(ElasticModel const& model, FaultState const& state)
      : nodes(std::make_shared<detail::MultigridNodes>(
          detail::makeNodes(*model.Z, model.nodes, model.held_rows)))
      , A(rcp(new detail::MultigridOperator(model.Z, nodes)))
  {
    nodes->set(state.blocks(model));
  }

  std::shared_ptr<detail::MultigridNodes> nodes;
  RCP<const detail::MultigridOperator> A;
};

RCP<detail::MultigridPreconditioner> makePreconditioner(ElasticModel const& model,
                                                        Parts const& parts)
{
  auto muelu = detail::MultigridHierarchy::defaults(model.options.components);
  muelu.set("coarse: max size", 100);
  const auto near_null_space = rcp(new MultiVector(*model.near_null_space, Teuchos::Copy));
  {
    auto values = near_null_space->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t k = 0; k < model.held_rows.extent(0); ++k) {
      for (int column = 0; column < values.extent_int(1); ++column) {
        values(model.held_rows(k), column) = 0;
      }
    }
  }
  return rcp(
    new detail::MultigridPreconditioner(parts.A, model.Z, near_null_space, parts.nodes, muelu));
}

RCP<CrsMatrix> copyOf(ElasticModel const& model)
{
  return rcp(new CrsMatrix(*model.Z, Teuchos::Copy));
}

ElasticModel modelWith(double tau, int tangents)
{
  ElasticModelOptions options;
  options.tau = tau;
  options.tangents = tangents;
  return ElasticModel(options);
}
} // namespace

TEST(MultigridPreconditioner, isSymmetricAfterEveryKindOfSetup)
{
  for (double tau : {1e-6, 1e3}) {
    for (int tangents : {1, 2}) {
      SCOPED_TRACE(tau);
      const auto model = modelWith(tau, tangents);
      const Parts parts(model, FaultState(model, Truncation::none));
      const auto B = makePreconditioner(model, parts);
      EXPECT_LE(detail::relativeAsymmetry(*B, *parts.nodes), 1e-12);
      parts.nodes->set(FaultState(model, Truncation::left_half).blocks(model));
      B->setup();
      EXPECT_LE(detail::relativeAsymmetry(*B, *parts.nodes), 1e-12);
      B->rebuild();
      EXPECT_LE(detail::relativeAsymmetry(*B, *parts.nodes), 1e-12);
      EXPECT_EQ(B->outdatedShare(), 0);
    }
  }
}

TEST(MultigridOperator, isTheTruncatedMatrix)
{
  for (int tangents : {1, 2}) {
    const auto model = modelWith(1.0, tangents);
    const FaultState state(model, Truncation::every_second, -2, 4);
    const Parts parts(model, state);
    const auto x =
      state.project(model, pseudorandomVector(static_cast<int>(model.global.rows()), 1));
    Vector y(model.map);
    parts.A->apply(model.scatter(x), y);
    const Eigen::VectorXd expected = state.matrix(model) * x;
    EXPECT_LE((model.gather(y) - expected).norm(), 1e-14 * expected.norm());
  }
}

// The sweep in the order of the colours, on the whole matrix.
TEST(MultigridSmoother, isGaussSeidelInTheOrderOfTheColours)
{
  const auto model = modelWith(1.0, 1);
  const FaultState state(model, Truncation::every_second, -2, 4);
  const Parts parts(model, state);
  detail::MultigridSmoother smoother(*model.Z, parts.nodes);
  smoother.setup();
  const auto r = state.project(model, pseudorandomVector(static_cast<int>(model.global.rows()), 1));
  const auto start =
    state.project(model, pseudorandomVector(static_cast<int>(model.global.rows()), 2));
  Vector z = model.scatter(start);
  smoother.sweep(detail::MultigridSmoother::Order::forward, model.scatter(r), z);

  const auto colouring = colourNodes(*model.Z->getCrsGraph(), model.nodes.dofs);
  Vector colour(model.map);
  for (std::size_t k = 0; k < model.mine.size(); ++k) {
    colour.replaceLocalValue(model.nodes.dofs(k, 0), 1.0 + colouring.colour[k]);
  }
  const auto colours = model.gather(colour);
  const auto A = state.matrix(model);
  Eigen::VectorXd expected = start;
  for (int c = 0; c < colouring.num_colours; ++c) {
    for (std::size_t node = 0; node < model.nonlinear.size(); ++node) {
      const int row = model.nonlinear[node][0];
      if (colours(row) == 1.0 + c && !state.truncated[node]) {
        expected(row) += (r(row) - A.col(row).dot(expected)) / A.coeff(row, row);
      }
    }
  }
  EXPECT_LE((model.gather(z) - expected).norm(), 1e-13 * expected.norm());
}

TEST(MultigridSymmetry, acceptsASymmetricMatrix)
{
  const auto model = modelWith(1.0, 1);
  const Parts parts(model, FaultState(model, Truncation::none));
  EXPECT_NO_THROW(detail::requireSymmetric(*model.Z, *parts.nodes));
}

TEST(MultigridSymmetry, findsOneAsymmetricEntry)
{
  const auto model = modelWith(1.0, 1);
  const Parts parts(model, FaultState(model, Truncation::none));
  const auto matrix = copyOf(model);
  matrix->resumeFill();
  const GlobalOrdinal row = 201;
  const GlobalOrdinal column = 203;
  if (matrix->getRowMap()->isNodeGlobalElement(row)) {
    const double change = 1e-3 * model.global.coeff(row, row);
    ASSERT_EQ(matrix->sumIntoGlobalValues(row, 1, &change, &column), 1);
  }
  matrix->fillComplete();
  EXPECT_THROW(detail::requireSymmetric(*matrix, *parts.nodes), SolveError);
}

TEST(MultigridSymmetry, refusesANegativeMatrix)
{
  const auto model = modelWith(1.0, 1);
  const Parts parts(model, FaultState(model, Truncation::none));
  const auto matrix = copyOf(model);
  matrix->resumeFill();
  matrix->scale(-1);
  matrix->fillComplete();
  EXPECT_THROW(detail::requireSymmetric(*matrix, *parts.nodes), SolveError);
}

TEST(CoarseCholesky, solvesWhatIsSpreadOverRanks)
{
  const auto model = modelWith(1.0, 1);
  const auto exact = pseudorandomVector(static_cast<int>(model.global.rows()), 1);
  const Vector b = model.scatter(model.global * exact);
  Vector x(model.map);
  detail::CoarseCholesky(*model.Z).solve(b, x);
  EXPECT_LE((model.gather(x) - exact).norm(), 1e-10 * exact.norm());
}

TEST(CoarseCholesky, refusesAnIndefiniteMatrixOnAllRanks)
{
  const auto model = modelWith(1.0, 1);
  const auto matrix = copyOf(model);
  matrix->resumeFill();
  if (const GlobalOrdinal row = 201; matrix->getRowMap()->isNodeGlobalElement(row)) {
    const double change = -2 * model.global.coeff(row, row);
    matrix->sumIntoGlobalValues(row, 1, &change, &row);
  }
  matrix->fillComplete();
  EXPECT_THROW(detail::CoarseCholesky{*matrix}, SolveError);
}

TEST(CoarseCholesky, takesARowOfZerosForIdentity)
{
  const auto model = modelWith(1.0, 1);
  const auto matrix = copyOf(model);
  const int row = model.constrained.front();
  matrix->resumeFill();
  if (const GlobalOrdinal id = row; matrix->getRowMap()->isNodeGlobalElement(id)) {
    const double zero = 0;
    matrix->replaceGlobalValues(id, 1, &zero, &id);
  }
  matrix->fillComplete();
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(model.global.rows());
  expected(row) = 3;
  Vector x(model.map);
  detail::CoarseCholesky(*matrix).solve(model.scatter(expected), x);
  EXPECT_EQ((model.gather(x) - expected).norm(), 0);
}
} // namespace asperity::tnnmg
