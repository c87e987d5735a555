#include "FaultState.hpp"
#include "base/parallel/Reductions.hpp"
#include "multigrid/CoarsestSolver.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/hierarchy/CoarseFault.hpp"
#include "tnnmg/multigrid/MultigridPreconditioner.hpp"
#include "tnnmg/multigrid/MultigridSymmetry.hpp"
#include "unit/base/Refusal.hpp"

#include <Eigen/SparseCholesky>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace asperity::tnnmg
{
using namespace testing;

namespace
{
// What MultigridCorrection makes of a model, in its parts.
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

// Rows per rank: more than any level here has, and enough to move level 1 from three ranks to two.
constexpr int all_on_one = 100000, some_on_one = 80;

std::shared_ptr<const detail::MultigridHierarchy>
hierarchyOf(ElasticModel const& model, std::vector<detail::MatrixSource> const& terms,
            int rows_per_rank)
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
  return std::make_shared<const detail::MultigridHierarchy>(
    terms, model.options.components, near_null_space, model.nodes.dofs,
    detail::Aggregation{muelu, rows_per_rank});
}

std::shared_ptr<const detail::MultigridHierarchy> hierarchyOf(ElasticModel const& model,
                                                              int rows_per_rank = 0)
{
  return hierarchyOf(model, {[&] { return model.Z; }}, rows_per_rank);
}

RCP<detail::MultigridPreconditioner> makePreconditioner(ElasticModel const& model,
                                                        Parts const& parts, int rows_per_rank)
{
  return rcp(new detail::MultigridPreconditioner(*hierarchyOf(model, rows_per_rank), {1}, model.Z,
                                                 parts.nodes));
}

// How many ranks have rows of a level.
int ranksOf(multigrid::Level const& level, Communicator const& communicator)
{
  return sumOverRanks(level.graph.num_rows > 0 ? 1 : 0, communicator);
}

int rowsOf(multigrid::Level const& level, Communicator const& communicator)
{
  return sumOverRanks(static_cast<int>(level.graph.rows()), communicator);
}

RCP<CrsMatrix> copyOf(ElasticModel const& model)
{
  return rcp(new CrsMatrix(*model.Z, Teuchos::Copy));
}

// Z without the entries that couple the first quarter of the nodes with the others. Two or three
// ranks part elsewhere, so that they still exchange values.
RCP<const CrsMatrix> cutInTwo(ElasticModel const& model)
{
  const auto num_nodes = model.global.rows() / model.options.components;
  const GlobalOrdinal end = num_nodes / 4 * model.options.components;
  const auto cut = rcp(new CrsMatrix(model.map, 20));
  for (int row = 0; row < static_cast<int>(numLocalElements(*model.map)); ++row) {
    const auto id = model.map->getGlobalElement(row);
    using Entry = Eigen::SparseMatrix<double>::InnerIterator; // symmetric: columns are rows
    for (Entry entry(model.global, static_cast<int>(id)); entry; ++entry) {
      const GlobalOrdinal other = entry.row();
      const double value = entry.value();
      if ((id < end) == (other < end)) {
        cut->insertGlobalValues(id, 1, &value, &other);
      }
    }
  }
  cut->fillComplete();
  return cut;
}

ElasticModel modelWith(double tau, int tangents)
{
  ElasticModelOptions options;
  options.tau = tau;
  options.tangents = tangents;
  return ElasticModel(options);
}
} // namespace

TEST(MultigridPreconditioner, IsSymmetricAfterEveryKindOfSetup)
{
  for (double tau : {1e-6, 1e3}) {
    for (int tangents : {1, 2}) {
      SCOPED_TRACE(tau);
      const auto model = modelWith(tau, tangents);
      const Parts parts(model, FaultState(model, Truncation::none));
      const auto B = makePreconditioner(model, parts,
                                        tau > 1         ? all_on_one
                                        : tangents == 1 ? 0
                                                        : some_on_one);
      EXPECT_LE(detail::relativeAsymmetry(*B, *parts.nodes), 1e-5); // single precision
      parts.nodes->set(FaultState(model, Truncation::left_half).blocks(model));
      B->setup();
      EXPECT_LE(detail::relativeAsymmetry(*B, *parts.nodes), 1e-5); // single precision
      B->rebuild();
      EXPECT_LE(detail::relativeAsymmetry(*B, *parts.nodes), 1e-5); // single precision
      EXPECT_EQ(B->outdatedShare(), 0);
    }
  }
}

// Aggregates do not cross ranks, so that more ranks make coarser levels larger unless these move.
TEST(MultigridHierarchy, HasCoarseLevelsOnFewerRanks)
{
  const auto model = modelWith(1.0, 1);
  auto const& comm = *model.map->getComm();
  const int num_ranks = comm.getSize();
  const auto spread = hierarchyOf(model, 0), moved = hierarchyOf(model, all_on_one);
  ASSERT_GE(moved->levels().size(), 3U); // so that a level is aggregated after it has moved
  EXPECT_EQ(ranksOf(spread->levels()[1], comm), num_ranks);
  EXPECT_EQ(ranksOf(moved->levels()[0], comm), num_ranks);
  EXPECT_EQ(rowsOf(moved->levels()[1], comm), rowsOf(spread->levels()[1], comm));
  for (std::size_t l = 1; l < moved->levels().size(); ++l) {
    EXPECT_EQ(ranksOf(moved->levels()[l], comm), 1) << "level " << l;
  }
  EXPECT_LE(rowsOf(moved->levels().back(), comm), 100);
  if (num_ranks == 3) {
    const auto partly = hierarchyOf(model, some_on_one);
    EXPECT_EQ(ranksOf(partly->levels()[1], comm), 2);
    EXPECT_EQ(ranksOf(partly->levels().back(), comm), 1);
  }
}

// The stiffness of right-angled tetrahedra has many stored zeros, and on one thread products leave
// out what one multiplies: a coarse matrix of another term may couple more than that of the first.
// A first term without these entries couples less on every backend.
TEST(MultigridHierarchy, HasTheCouplingsOfAllTerms)
{
  const auto model = modelWith(1.0, 1);
  const auto cut = cutInTwo(model);
  const auto hierarchy = hierarchyOf(model, {[&] { return cut; }, [&] { return model.Z; }}, 0);
  ASSERT_GE(hierarchy->levels().size(), 2U);
  const auto cut_alone = hierarchyOf(model, {[&] { return cut; }}, 0);
  const auto couplings = [&](detail::MultigridHierarchy const& of) {
    return sumOverRanks(of.levels()[1].graph.numCouplings(), *model.map->getComm());
  };
  EXPECT_GT(couplings(*hierarchy), couplings(*cut_alone));
}

// The product with Z + H that a cycle leaves is that of the operator, to single precision.
TEST(Cycle, GivesTheImageOfItsResult)
{
  for (int tangents : {1, 2}) {
    for (auto truncation : {Truncation::none, Truncation::every_second}) {
      const auto model = modelWith(1.0, tangents);
      const Parts parts(model, FaultState(model, truncation, -2, 2));
      auto const hierarchy = hierarchyOf(model, tangents == 1 ? 0 : all_on_one);
      std::vector<char> held(numLocalRows(*model.Z), 0);
      for (std::size_t k = 0; k < model.held_rows.extent(0); ++k) {
        held[toHost(model.held_rows)(k)] = 1;
      }
      multigrid::Cycle cycle(hierarchy->shared(), {1}, hierarchy->finestBlocks(*model.Z), held,
                             toHost(model.nodes.dofs));
      ASSERT_TRUE(cycle.setup(toHost(parts.nodes->hessian), toHost(parts.nodes->removed)));
      const auto r = detail::pseudorandomVector(model.map, 0, *parts.nodes);
      const auto given = r.getLocalViewHost(Tpetra::Access::ReadOnly);
      auto const result =
        cycle.run(multigrid::NodeVector(given.data(), given.data() + given.extent(0)), true);
      Vector z(model.map), image(model.map), expected(model.map);
      const auto copy = [](multigrid::NodeVector const& from, Vector& to) {
        std::copy_n(from.begin(), to.getLocalLength(),
                    to.getLocalViewHost(Tpetra::Access::OverwriteAll).data());
      };
      copy(result.z, z);
      copy(result.image, image);
      EXPECT_GT(z.norm2(), 0);
      parts.A->apply(z, expected);
      image.update(-1, expected, 1);
      EXPECT_LE(image.norm2(), 1e-5 * expected.norm2());
    }
  }
}

TEST(MultigridOperator, IsTheTruncatedMatrix)
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

// On the coarse levels P^T (A + sum of Q^T H Q) P is the Galerkin product of A + H: the energy of a
// coarse function is that of the fine function that it stands for.
TEST(CoarseFault, IsTheGalerkinProductOfTheHessians)
{
  for (int tangents : {1, 2}) {
    const auto model = modelWith(1.0, tangents);
    const FaultState state(model, Truncation::none, -2, 0);
    const Parts parts(model, state);
    const auto hierarchy = hierarchyOf(model, tangents == 1 ? some_on_one : all_on_one);
    ASSERT_GE(hierarchy->levels().size(), 2U);
    auto const& fine = hierarchy->levels()[0];
    auto const& coarse = hierarchy->levels()[1];
    // Of a coarse function x, the fine function P x.
    multigrid::NodeVector x(fine.prolongation.columnsWithGhosts());
    const auto owned = coarse.graph.rows();
    for (std::size_t i = 0; i < owned; ++i) {
      x[i] = static_cast<float>(std::sin(1.0 + static_cast<double>(i)));
    }
    fine.prolongation.share(x);
    multigrid::NodeVector Px(fine.graph.rows(), 0.);
    multiplyAdd(fine.prolongation, fine.chunks, fine.P, x, Px);
    Vector Px_vector(model.map);
    std::copy(Px.begin(), Px.end(),
              Px_vector.getLocalViewHost(Tpetra::Access::OverwriteAll).data());
    const auto u = model.gather(Px_vector);
    const double expected = u.dot(state.matrix(model) * u);

    auto A = coarse.terms[0];
    std::vector<double> hessian;
    hessian.reserve(parts.nodes->hessian.size());
    for (int k = 0; k < static_cast<int>(parts.nodes->hessian.size()); ++k) {
      hessian.push_back(parts.nodes->hessian.data()[k]);
    }
    coarse.added.addTo(A, hessian);
    multigrid::NodeVector on_level(coarse.graph.columnsWithGhosts());
    std::copy_n(x.begin(), owned, on_level.begin());
    coarse.graph.share(on_level);
    multigrid::NodeVector Ax(owned, 0.);
    multiplyAdd(coarse.graph, coarse.chunks, A, on_level, Ax);
    double energy = 0;
    for (std::size_t i = 0; i < owned; ++i) {
      energy += x[i] * Ax[i];
    }
    EXPECT_NEAR(sumOverRanks(energy, *model.map->getComm()), expected, 1e-5 * expected);
  }
}

// A rank may have none.
TEST(CoarseFault, TakesAMatrixWithoutEntries)
{
  const auto model = modelWith(1.0, 1);
  CrsMatrix P(model.map, 0);
  P.fillComplete();
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> dofs("dofs", 3, 1);
  const auto Q = detail::rowsAtNodes(P, dofs);
  EXPECT_EQ(numLocalElements(*Q->getRowMap()), 3U);
  EXPECT_EQ(Q->getGlobalNumEntries(), 0U);
}

TEST(MultigridSymmetry, AcceptsASymmetricMatrix)
{
  const auto model = modelWith(1.0, 1);
  const Parts parts(model, FaultState(model, Truncation::none));
  EXPECT_NO_THROW(detail::requireSymmetric(*model.Z, *parts.nodes, 1e-8));
}

TEST(MultigridSymmetry, FindsOneAsymmetricEntry)
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
  EXPECT_THROW(detail::requireSymmetric(*matrix, *parts.nodes, 1e-8), SolveError);
}

TEST(MultigridSymmetry, RefusesANegativeMatrix)
{
  const auto model = modelWith(1.0, 1);
  const Parts parts(model, FaultState(model, Truncation::none));
  const auto matrix = copyOf(model);
  matrix->resumeFill();
  matrix->scale(-1);
  matrix->fillComplete();
  EXPECT_THROW(detail::requireSymmetric(*matrix, *parts.nodes, 1e-8), SolveError);
}

namespace
{
// A solver for the whole matrix of a model, or null.
std::unique_ptr<multigrid::CoarsestSolver> solverFor(RCP<const CrsMatrix> const& matrix, int size)
{
  auto const [graph, maps] = detail::makeNodeGraph({matrix}, size, size);
  return multigrid::CoarsestSolver::make(graph, detail::coarsestRows(maps),
                                         detail::blocksOf(graph, maps, *matrix),
                                         std::vector<char>(numLocalRows(*matrix), 1));
}
} // namespace

// To single precision, in which multigrid has its matrices: an inexact solve is a preconditioner.
TEST(CoarsestSolver, SolvesWhatIsSpreadOverRanks)
{
  const auto model = modelWith(1.0, 1);
  const auto coarsest = solverFor(model.Z, model.options.components);
  ASSERT_TRUE(coarsest);
  const auto exact = pseudorandomVector(static_cast<int>(model.global.rows()), 1);
  const Vector b = model.scatter(model.global * exact);
  Vector x(model.map);
  const auto rows = b.getLocalLength();
  const auto values = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  multigrid::NodeVector mine(values.data(), values.data() + rows), solution(rows);
  coarsest->solve(mine, solution);
  std::copy(solution.begin(), solution.end(),
            x.getLocalViewHost(Tpetra::Access::OverwriteAll).data());
  const Eigen::VectorXd error = model.gather(x) - exact;
  EXPECT_LE(std::sqrt(error.dot(model.global * error)),
            1e-4 * std::sqrt(exact.dot(model.global * exact)));
}

// Before it has taken memory for them.
TEST(CoarsestSolver, RefusesMoreRowsThanEveryRankCanHave)
{
  const auto rows =
    rcp(new Map(multigrid::CoarsestRows::most + 1, 0, modelWith(1.0, 1).map->getComm()));
  const auto identity = rcp(new CrsMatrix(rows, 1));
  for (std::size_t row = 0; row < numLocalElements(*rows); ++row) {
    const auto id = rows->getGlobalElement(static_cast<int>(row));
    const double one = 1;
    identity->insertGlobalValues(id, 1, &one, &id);
  }
  identity->fillComplete();
  test::expectRefusal<SolveError>([&] { solverFor(identity, 1); }, {"20001 rows"});
}

TEST(CoarsestSolver, RefusesAnIndefiniteMatrixOnAllRanks)
{
  const auto model = modelWith(1.0, 1);
  const auto matrix = copyOf(model);
  matrix->resumeFill();
  if (const GlobalOrdinal row = 201; matrix->getRowMap()->isNodeGlobalElement(row)) {
    const double change = -2 * model.global.coeff(row, row);
    matrix->sumIntoGlobalValues(row, 1, &change, &row);
  }
  matrix->fillComplete();
  EXPECT_FALSE(solverFor(matrix, model.options.components));
}
} // namespace asperity::tnnmg
