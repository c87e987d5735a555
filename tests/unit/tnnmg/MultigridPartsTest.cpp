#include "FaultState.hpp"
#include "base/parallel/Reductions.hpp"
#include "multigrid/CoarsestSolver.hpp"
#include "multigrid/Renumbering.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/correction/MultigridSymmetry.hpp"
#include "tnnmg/correction/OwnPreconditioner.hpp"
#include "tnnmg/hierarchy/CoarseFault.hpp"
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
using namespace tnnmg::test;

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
            int rows_per_rank, multigrid::RowOrder order = multigrid::defaultRowOrder())
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
    detail::Aggregation{muelu, rows_per_rank, order});
}

std::shared_ptr<const detail::MultigridHierarchy>
hierarchyOf(ElasticModel const& model, int rows_per_rank = 0,
            multigrid::RowOrder order = multigrid::defaultRowOrder())
{
  return hierarchyOf(model, {[&] { return model.Z; }}, rows_per_rank, order);
}

// Where kernels run on the host, both orders can.
std::vector<multigrid::RowOrder> rowOrders()
{
  if (kernels_run_on_host) {
    return {multigrid::RowOrder::chunks, multigrid::RowOrder::colours};
  }
  return {multigrid::RowOrder::colours};
}

RCP<detail::OwnPreconditioner>
makePreconditioner(ElasticModel const& model, Parts const& parts, int rows_per_rank,
                   multigrid::RowOrder order = multigrid::defaultRowOrder())
{
  return rcp(new detail::OwnPreconditioner(*hierarchyOf(model, rows_per_rank, order), {1}, model.Z,
                                           parts.nodes));
}

// The only column of a vector.
template <class View>
auto column(View const& view)
{
  return Kokkos::subview(view, Kokkos::ALL(), 0);
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

TEST(OwnPreconditioner, IsSymmetricAfterEveryKindOfSetup)
{
  for (auto order : rowOrders()) {
    for (double tau : {1e-6, 1e3}) {
      for (int tangents : {1, 2}) {
        SCOPED_TRACE(tau);
        const auto model = modelWith(tau, tangents);
        const Parts parts(model, FaultState(model, Truncation::none));
        const int few_ranks = tangents == 1 ? 0 : some_on_one;
        const auto B = makePreconditioner(model, parts, tau > 1 ? all_on_one : few_ranks, order);
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

namespace
{
void expectImage(int tangents, Truncation truncation, multigrid::RowOrder order)
{
  const auto model = modelWith(1.0, tangents);
  const Parts parts(model, FaultState(model, truncation, -2, 2));
  auto const hierarchy = hierarchyOf(model, tangents == 1 ? 0 : all_on_one, order);
  std::vector<char> held(numLocalRows(*model.Z), 0);
  for (std::size_t k = 0; k < model.held_rows.extent(0); ++k) {
    held[toHost(model.held_rows)(k)] = 1;
  }
  multigrid::Cycle cycle(hierarchy->shared(), {1}, hierarchy->finestBlocks(*model.Z), held,
                         model.nodes.dofs);
  ASSERT_TRUE(cycle.setup(parts.nodes->hessian, parts.nodes->removed));
  const auto r = detail::pseudorandomVector(model.map, 0, *parts.nodes);
  const auto given = multigrid::makeNumbers(cycle.rows());
  cycle.toRows(column(r.getLocalViewDevice(Tpetra::Access::ReadOnly)), 1, given);
  auto const result = cycle.run(given, true);
  Vector z(model.map), image(model.map), expected(model.map);
  cycle.fromRows(result.z, 1, column(z.getLocalViewDevice(Tpetra::Access::OverwriteAll)));
  cycle.fromRows(result.image, 1, column(image.getLocalViewDevice(Tpetra::Access::OverwriteAll)));
  EXPECT_GT(z.norm2(), 0);
  parts.A->apply(z, expected);
  image.update(-1, expected, 1);
  EXPECT_LE(image.norm2(), 1e-5 * expected.norm2());
}
} // namespace

// The product with Z + H that a cycle leaves is that of the operator, to single precision.
TEST(Cycle, GivesTheImageOfItsResult)
{
  for (auto order : rowOrders()) {
    for (int tangents : {1, 2}) {
      expectImage(tangents, Truncation::none, order);
      expectImage(tangents, Truncation::every_second, order);
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
namespace
{
// The numbers of rows at the nodes whose they are.
template <class Numbers, class Rows>
void copyToNodes(Numbers const& of_rows, Rows const& row_of_node, int size, Vector& of_nodes)
{
  const auto to = of_nodes.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (int i = 0; i < to.extent_int(0); ++i) {
    const int row = row_of_node.extent(0) > 0 ? row_of_node(i / size) : i / size;
    to(i, 0) = of_rows(row * size + i % size);
  }
}

void expectGalerkinProduct(int tangents, multigrid::RowOrder order)
{
  const auto model = modelWith(1.0, tangents);
  const FaultState state(model, Truncation::none, -2, 0);
  const Parts parts(model, state);
  const auto hierarchy = hierarchyOf(model, tangents == 1 ? some_on_one : all_on_one, order);
  ASSERT_GE(hierarchy->levels().size(), 2U);
  auto const& fine = hierarchy->levels()[0];
  auto const& coarse = hierarchy->levels()[1];
  // Of a coarse function x, the fine function P x.
  const auto x = multigrid::makeNumbers(fine.prolongation.columnsWithGhosts());
  const auto owned = coarse.graph.rows();
  const auto x_on_host = Kokkos::create_mirror_view(x);
  for (std::size_t i = 0; i < owned; ++i) {
    x_on_host(i) = static_cast<float>(std::sin(1.0 + static_cast<double>(i)));
  }
  Kokkos::deep_copy(x, x_on_host);
  fine.prolongation.share(x);
  const auto Px = multigrid::makeNumbers(fine.graph.rows());
  multiplyAdd(fine.prolongation, fine.schedule, fine.P, x, Px);
  Vector Px_vector(model.map);
  copyToNodes(toHost(Px), toHost(hierarchy->shared()->rowOfNode()), model.options.components,
              Px_vector);
  const auto u = model.gather(Px_vector);
  const double expected = u.dot(state.matrix(model) * u);

  const auto A = multigrid::makeNumbers(coarse.terms[0].extent(0));
  Kokkos::deep_copy(A, coarse.terms[0]);
  coarse.added.addTo(A, parts.nodes->hessian);
  const auto on_level = multigrid::makeNumbers(coarse.graph.columnsWithGhosts());
  Kokkos::deep_copy(Kokkos::subview(on_level, std::make_pair(std::size_t(0), owned)),
                    Kokkos::subview(x, std::make_pair(std::size_t(0), owned)));
  coarse.graph.share(on_level);
  const auto Ax = multigrid::makeNumbers(owned);
  multiplyAdd(coarse.graph, coarse.schedule, A, on_level, Ax);
  const auto Ax_on_host = toHost(Ax);
  double energy = 0;
  for (std::size_t i = 0; i < owned; ++i) {
    energy += x_on_host(i) * Ax_on_host(i);
  }
  EXPECT_NEAR(sumOverRanks(energy, *model.map->getComm()), expected, 1e-5 * expected);
}
} // namespace

TEST(CoarseFault, IsTheGalerkinProductOfTheHessians)
{
  for (auto order : rowOrders()) {
    expectGalerkinProduct(1, order);
    expectGalerkinProduct(2, order);
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
  return multigrid::CoarsestSolver::make(
    multigrid::MatrixGraph(graph), detail::coarsestRows(maps),
    multigrid::onDevice(multigrid::renumbered(detail::blocksOf(graph, maps, *matrix),
                                              multigrid::MatrixGraph::order(graph),
                                              graph.blockSize())),
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
  const auto mine = multigrid::makeNumbers<multigrid::HostBlocks>(rows);
  std::copy_n(values.data(), rows, mine.data());
  const auto solution = multigrid::makeNumbers(rows);
  coarsest->solve(multigrid::onDevice(mine), solution);
  const auto on_host = toHost(solution);
  std::copy_n(on_host.data(), rows, x.getLocalViewHost(Tpetra::Access::OverwriteAll).data());
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
  asperity::test::expectRefusal<SolveError>([&] { solverFor(identity, 1); }, {"20001 rows"});
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
