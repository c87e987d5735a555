#include "ChainOfSprings.hpp"
#include "multigrid/CoarsestSolver.hpp"
#include "multigrid/FloatConjugateGradients.hpp"
#include "multigrid/NodeMatrix.hpp"
#include "multigrid/Renumbering.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace asperity::multigrid
{
using namespace multigrid::test;

namespace
{
// All that a smoother from outside is. It does nothing, so that the cycle is the coarse correction.
class Nothing final : public Smoother
{
public:
  static constexpr char const* meaning = "nothing is smoothed.";
  void presmooth(LevelMatrix const&, NodeVector const& b, NodeVector const& x,
                 NodeVector const& residual) override
  {
    Kokkos::deep_copy(x, 0.f);
    Kokkos::deep_copy(residual, b);
  }
  void postsmooth(LevelMatrix const&, NodeVector const&, NodeVector const&,
                  NodeVector const&) override
  {
  }
  void image(LevelMatrix const& matrix, NodeVector const& x, NodeVector const& image) override
  {
    Kokkos::deep_copy(image, 0.f);
    multiplyAdd(matrix.level.graph, matrix.level.schedule, matrix.A, x, image);
  }
};
} // namespace

ASPERITY_REGISTER(SmootherRegistry, "Nothing", SmootherKindOf<Nothing>)

TEST(Cycle, IsSymmetricAndGivesTheImageOfItsResult)
{
  for (auto const& smoother : smoothers()) {
    for (auto order : orders()) {
      SCOPED_TRACE(smoother);
      const Chain chain(order, 2.01, 0, smoother);
      ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
      const auto A = Chain::matrix();
      const auto r = Chain::force(0), q = Chain::force(1);
      const auto [z, image] = chain.run(r);
      for (int node = 0; node < num_nodes; ++node) {
        EXPECT_EQ(z(node) != 0, Chain::isFree(node)) << node;
      }
      EXPECT_LE((A * z - image).norm(), 1e-5 * image.norm());
      const auto y = chain.run(q).z;
      EXPECT_NEAR(z.dot(q), y.dot(r), 1e-5 * z.norm() * q.norm());
      EXPECT_GT(z.dot(r), 0);
    }
  }
}

// In a chain whose chunks are coupled more strongly than nodes with themselves. Without damping the
// smallest eigenvalue of Gauss-Seidel would be -0.0006, and Jacobi would be indefinite by far. The
// sweeps contract in the energy norm, and so does the cycle.
TEST(Cycle, IsPositiveHoweverStronglyChunksAreCoupled)
{
  for (auto const& smoother : smoothers()) {
    for (auto order : orders()) {
      SCOPED_TRACE(smoother);
      const Chain chain(order, 2.01, 12, smoother);
      const HessianView no_blocks("H", num_nodes, 1, 1);
      const FlagView none_removed("removed", num_nodes);
      ASSERT_TRUE(chain.cycle->setup(no_blocks, none_removed));
      Eigen::MatrixXd B(last, last);
      for (int node = 0; node < last; ++node) {
        B.col(node) = chain.run(Eigen::VectorXd::Unit(num_nodes, node)).z.head(last);
      }
      EXPECT_LE((B - B.transpose()).norm(), 1e-5 * B.norm());
      const Eigen::MatrixXd symmetric = (B + B.transpose()) / 2;
      // B x = lambda A^-1 x has the eigenvalues of B A.
      const Eigen::MatrixXd A = multigrid::test::chain(2.01, 12).topLeftCorner(last, last);
      const auto eigenvalues = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                                 symmetric, A.inverse(), Eigen::EigenvaluesOnly)
                                 .eigenvalues()
                                 .eval();
      EXPECT_GT(eigenvalues.minCoeff(), 0);
      // Rounding to 6e-8 times the condition number of A, 1600.
      EXPECT_LE(eigenvalues.maxCoeff(), 1 + 1e-4);
    }
  }
}

// Gauss-Seidel depends on the order, the others are what they are in any.
TEST(Smoothers, AreTheSameInAnyOrderOfRowsUnlessTheyAreGaussSeidel)
{
  for (auto const& smoother : smoothers()) {
    std::vector<Eigen::VectorXd> results;
    for (auto order : orders()) {
      const Chain chain(order, 2.01, 0, smoother);
      ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
      results.push_back(chain.run(Chain::force(0)).z);
    }
    for (auto const& result : results) {
      const double difference = (result - results.front()).norm() / results.front().norm();
      if (smoother == Cycle::usual_smoother && &result != &results.front()) {
        EXPECT_GT(difference, 1e-4);
      } else {
        EXPECT_LE(difference, 1e-5) << smoother;
      }
    }
  }
}

// z = P (P^T Z P)^-1 P^T r; the coarsest diagonal is larger by a millionth.
TEST(Smoothers, OneFromOutsideIsFoundByItsName)
{
  const Chain chain({}, 2.01, 0, "Nothing");
  const HessianView no_blocks("H", num_nodes, 1, 1);
  const FlagView none_removed("removed", num_nodes);
  ASSERT_TRUE(chain.cycle->setup(no_blocks, none_removed));
  Eigen::VectorXd r = Chain::force(0);
  const auto [z, image] = chain.run(r);
  const Eigen::MatrixXd P = prolongator(), A = multigrid::test::chain();
  const Eigen::MatrixXd coarse = P.transpose() * A * P;
  const Eigen::VectorXd expected = P * coarse.ldlt().solve(P.transpose() * r);
  EXPECT_LE((z - expected).norm(), 1e-3 * expected.norm());
  EXPECT_LE((A * z - image).norm(), 1e-5 * image.norm());
}

TEST(Smoothers, AreRegistered)
{
  EXPECT_EQ(smoothers(), std::vector<std::string>({"Block Jacobi", "Chebyshev", "Gauss-Seidel"}));
  EXPECT_THROW(Chain({}, 2.01, 0, "Soap"), std::out_of_range);
}

// The largest eigenvalue of D^-1 A of the chain is 1 + cos(pi / 900) / 1.005 = 1.995, below the
// bound t of the polynomial, so that E is zero. From zero a sweep is 4 / t (u - 4 / (5 t) w) with
// u = D^-1 b, w = D^-1 A u. Errors of eigenvalue 1 vanish: the fifth of a period is cos(2 pi / 5).
TEST(Smoothers, ChebyshevIsAPolynomialWithARootAtOne)
{
  const Chain chain({defaultRowOrder(), 1});
  auto const& level = chain.hierarchy->levels()[0];
  const Matrix given(multigrid::test::chain());
  LevelMatrix matrix = {level, chain.hierarchy->inOrder(given.blocks),
                        {},    numbers(Eigen::VectorXd::Constant(num_nodes, 1 / 2.01)),
                        {},    [](double*, int) {}};
  const auto smoother = SmootherRegistry::instance().at("Chebyshev").make();
  smoother->damp(matrix);
  smoother->matrixChanged(matrix);
  const Eigen::VectorXd b = Chain::force(0);
  const auto on_rows = makeNumbers(num_nodes), x = makeNumbers(num_nodes);
  const auto residual = makeNumbers(num_nodes);
  chain.cycle->toRows(Chain::onNodes(b), 1, on_rows);
  smoother->presmooth(matrix, on_rows, x, residual);
  const Eigen::VectorXd found = chain.fromRows(x);
  const Eigen::MatrixXd A = multigrid::test::chain();
  const Eigen::VectorXd u = b / 2.01, w = A * u / 2.01;
  const double t = 2 / (1 - std::cos(2 * M_PI / 5));
  EXPECT_LE((4 / t * u - 3.2 / (t * t) * w - found).norm(), 1e-5 * found.norm());
  EXPECT_NEAR(1 - 4 / t + 3.2 / (t * t), 0, 1e-12);
  EXPECT_LE((b - A * found - chain.fromRows(residual)).norm(), 1e-5 * b.norm());
}

// With three threads each of two levels has three chunks and one.
TEST(Schedule, HasAChunkForEachThreadUnlessItIsSmall)
{
  const auto hierarchy = twoLevels(2.01, {RowOrder::chunks, 3});
  EXPECT_EQ(hierarchy->levels()[0].schedule.numParts(), 3);
  EXPECT_EQ(hierarchy->levels()[1].schedule.numParts(), 1);
}

// A grid of 64 by 48 nodes that are numbered at random, each coupled with its neighbours. Two cuts
// across the grid would cut 2 * 48 of some 6,000 couplings, rows as they are numbered two thirds.
TEST(Renumbering, RegionsLieTogether)
{
  constexpr int width = 64, height = 48, num_rows = width * height;
  const auto number = [](int x, int y) { return (x + width * y) * 1193 % num_rows; }; // a bijection
  std::vector<std::vector<int>> coupled(num_rows);
  for (int x = 0; x < width; ++x) {
    for (int y = 0; y < height; ++y) {
      auto& of_node = coupled[number(x, y)];
      of_node.push_back(number(x, y));
      for (auto [i, k] : {std::pair(x - 1, y), {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
        if (i >= 0 && i < width && k >= 0 && k < height) {
          of_node.push_back(number(i, k));
        }
      }
      std::sort(of_node.begin(), of_node.end());
    }
  }
  HostGraph graph;
  graph.num_rows = graph.num_owned = graph.num_columns = num_rows;
  graph.first = {0};
  for (auto const& of_node : coupled) {
    graph.columns.insert(graph.columns.end(), of_node.begin(), of_node.end());
    graph.first.push_back(static_cast<int>(graph.columns.size()));
  }
  const auto parts = regions(graph, 3);
  ASSERT_EQ(parts.begins.size(), 4u);
  EXPECT_EQ(parts.begins.back(), num_rows);
  std::vector<int> region(num_rows), last_row(3, -1);
  for (int node = 0; node < num_rows; ++node) {
    const int row = parts.row_of_node[node];
    region[node] = row < parts.begins[1] ? 0 : row < parts.begins[2] ? 1 : 2;
    EXPECT_GT(row, last_row[region[node]]) << "nodes of a region keep their order";
    last_row[region[node]] = row;
  }
  int cut = 0; // couplings, each of which two nodes have
  for (int node = 0; node < num_rows; ++node) {
    cut += static_cast<int>(std::count_if(coupled[node].begin(), coupled[node].end(),
                                          [&](int k) { return region[k] != region[node]; }));
  }
  EXPECT_LE(cut / 2, 4 * height);
  for (int part = 0; part < 3; ++part) {
    EXPECT_NEAR(parts.begins[part + 1] - parts.begins[part], num_rows / 3, num_rows / 30);
  }
  EXPECT_TRUE(regions(graph, 1).row_of_node.empty());
}

TEST(MatrixGraph, HasBothHalvesOneAfterTheOther)
{
  HostGraph graph;
  graph.row_size = graph.column_size = 1;
  graph.num_rows = graph.num_owned = 3;
  graph.num_columns = 4;      // node 3 is a ghost
  graph.first = {0, 3, 5, 8}; // node 1 has no coupling with itself
  graph.columns = {0, 1, 2, 0, 3, 0, 1, 2};
  EXPECT_EQ(MatrixGraph::order(graph), std::vector<int>({3, 5, 6, 0, 7, 1, 2, 4}));
  const MatrixGraph ordered(graph);
  std::vector<int> rows(8), columns(8);
  ordered.forEachCoupling([&](int row, int column, int k) {
    rows[k] = row;
    columns[k] = column;
  });
  EXPECT_EQ(rows, std::vector<int>({1, 2, 2, 0, 2, 0, 0, 1}));
  EXPECT_EQ(columns, std::vector<int>({0, 0, 1, 0, 2, 1, 2, 3}));
}

// In a chain that is cut before the held node: even nodes and that one, then odd ones.
TEST(Schedule, HasRowsOfOneColourThatAreNotCoupled)
{
  const auto hierarchy = twoLevels(2.01, {RowOrder::colours, 1});
  auto const& level = hierarchy->levels()[0];
  EXPECT_EQ(level.schedule.numParts(), 2);
  const auto row_of_node = toHost(hierarchy->rowOfNode());
  constexpr int num_even = num_nodes / 2 + 1;
  for (int node = 0; node < last; ++node) {
    EXPECT_EQ(row_of_node(node), node / 2 + (node % 2 == 0 ? 0 : num_even));
  }
  level.graph.forEachCoupling([](int row, int column, int) {
    const bool is_even = row < num_even, other_is_even = column < num_even;
    EXPECT_TRUE(column == row || is_even != other_is_even);
  });
}

// The order changes the sweep, but not what the iteration reaches.
TEST(FloatConjugateGradients, NeedAboutAsManyIterationsInEveryOrder)
{
  std::vector<int> iterations;
  for (auto order : orders()) {
    const Chain chain(order);
    chain.cycle->setCoarseBlocks(chain.H);
    ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
    FloatConjugateGradients gradients(*chain.cycle, [](double*, int) {});
    const auto r = Chain::force(0);
    const NodeView c("c", num_nodes);
    const auto result = gradients.solve(Chain::onNodes(r), r.norm(), 1e-3, 100, c);
    EXPECT_TRUE(result.converged);
    EXPECT_LE((r - Chain::matrix() * Chain::ofNodes(c)).norm(), 1.01e-3 * r.norm());
    iterations.push_back(result.iterations);
  }
  // Chunks cut a chain at one node of 300: the sweep differs there alone. With colours it differs
  // everywhere.
  for (int count : iterations) {
    EXPECT_LE(count, std::max(iterations.front() + 1, 3 * iterations.front() / 2));
  }
}

// The count of Gauss-Seidel is today's; Jacobi reads the matrix three times in a cycle where
// Gauss-Seidel reads it two and a half times, and Chebyshev five times.
TEST(FloatConjugateGradients, ConvergeWithEverySmoother)
{
  std::map<std::string, int> iterations;
  for (auto const& smoother : smoothers()) {
    for (auto order : orders()) {
      const Chain chain(order, 2.01, 0, smoother);
      chain.cycle->setCoarseBlocks(chain.H);
      ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
      FloatConjugateGradients gradients(*chain.cycle, [](double*, int) {});
      const auto r = Chain::force(0);
      const NodeView c("c", num_nodes);
      const auto result = gradients.solve(Chain::onNodes(r), r.norm(), 1e-3, 100, c);
      EXPECT_TRUE(result.converged) << smoother;
      EXPECT_LE((r - Chain::matrix() * Chain::ofNodes(c)).norm(), 1.01e-3 * r.norm());
      iterations[smoother] = std::max(iterations[smoother], result.iterations);
    }
  }
  EXPECT_LE(iterations["Chebyshev"], iterations["Gauss-Seidel"] + 1);
  EXPECT_LE(iterations["Block Jacobi"], 2 * iterations["Gauss-Seidel"]);
}

TEST(Cycle, RefusesAnIndefiniteMatrix)
{
  const Chain chain({}, 1.5); // positive on both diagonals
  EXPECT_FALSE(chain.cycle->setup(chain.H, chain.removed));
}

TEST(Cycle, RefusesMoreTermsThanItHasRoomFor)
{
  const std::vector<double> weights(Cycle::most_terms + 1, 1.);
  EXPECT_THROW(Cycle(nullptr, weights, {}, {}, {}), std::invalid_argument);
}

TEST(FloatConjugateGradients, SolveToTheirTolerance)
{
  const Chain chain;
  chain.cycle->setCoarseBlocks(chain.H);
  ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
  int reductions = 0;
  FloatConjugateGradients gradients(*chain.cycle, [&](double*, int) { ++reductions; });
  const auto r = Chain::force(0);
  const auto given = Chain::onNodes(r);
  const NodeView c("c", num_nodes);
  for (double tolerance : {1e-1, FloatConjugateGradients::smallest_tolerance}) {
    reductions = 0;
    const auto result = gradients.solve(given, r.norm(), tolerance, 100, c);
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(reductions, result.iterations) << "one in each iteration";
    EXPECT_LE((r - Chain::matrix() * Chain::ofNodes(c)).norm(), 1.01 * tolerance * r.norm());
  }
  EXPECT_FALSE(gradients.solve(given, r.norm(), 1e-3, 1, c).converged);
  Kokkos::deep_copy(given, 0.);
  EXPECT_TRUE(gradients.solve(given, 0, 1e-3, 100, c).converged);
  EXPECT_EQ(Chain::ofNodes(c).norm(), 0);
}

// The energy of a coarse function is that of the fine function that it stands for.
TEST(AddedBlocks, AreAGalerkinProduct)
{
  for (auto order : orders()) {
    const Chain chain(order);
    auto const& level = chain.hierarchy->levels()[1];
    const auto A = makeNumbers(level.terms[0].extent(0));
    Kokkos::deep_copy(A, level.terms[0]);
    level.added.addTo(A, chain.H);
    Eigen::MatrixXd fine = multigrid::test::chain();
    for (int node = 0; node < num_nodes; ++node) {
      fine(node, node) += Chain::blockAt(node);
    }
    const Eigen::MatrixXd expected = prolongator().transpose() * fine * prolongator();
    const auto sum = toHost(A);
    level.graph.forEachCoupling(
      [&](int row, int column, int k) { EXPECT_NEAR(sum(k), expected(row, column), 1e-6); });
  }
}

TEST(CoarsestSolver, LeavesOutWhatIsNotFree)
{
  const Matrix A(chain());
  std::vector<char> free(num_nodes, 1);
  free[5] = free[20] = 0;
  const auto solver =
    CoarsestSolver::make(MatrixGraph(A.graph), allRows(num_nodes),
                         onDevice(renumbered(A.blocks, MatrixGraph::order(A.graph), 1)), free);
  ASSERT_TRUE(solver);
  Eigen::MatrixXd part = chain();
  Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(num_nodes, 1, 2);
  const auto given = numbers(b), x = makeNumbers(num_nodes);
  for (int i : {5, 20}) {
    part.row(i).setZero();
    part.col(i).setZero();
    part(i, i) = 1;
    b(i) = 0;
  }
  solver->solve(given, x);
  const Eigen::VectorXd exact = part.llt().solve(b);
  // The diagonal is larger by a millionth, and the condition number is 401.
  EXPECT_LE((valuesOf(x) - exact).norm(), 1.1 * 401e-6 * exact.norm());
  EXPECT_EQ(valuesOf(x)(5), 0);
}
} // namespace asperity::multigrid
