#include "multigrid/Cycle.hpp"

#include "multigrid/CoarsestSolver.hpp"
#include "multigrid/FloatConjugateGradients.hpp"
#include "multigrid/Renumbering.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace asperity::multigrid
{
namespace
{
constexpr int num_nodes = 900, width = 3; // of an aggregate
constexpr int last = num_nodes - 1;       // which is held

// A chain of springs with weak supports, whose last node is held. With a diagonal below 2 it is
// indefinite.
Eigen::MatrixXd chain(double diagonal = 2.01)
{
  Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(num_nodes, num_nodes);
  for (int i = 0; i < num_nodes; ++i) {
    Z(i, i) = diagonal;
    if (i > 0 && i < last) {
      Z(i, i - 1) = Z(i - 1, i) = -1;
    }
  }
  return Z;
}

// Constant on aggregates, zero at the held node.
Eigen::MatrixXd prolongator()
{
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(num_nodes, num_nodes / width);
  for (int i = 0; i < last; ++i) {
    P(i, i / width) = 1;
  }
  return P;
}

struct Matrix
{
  explicit Matrix(Eigen::MatrixXd const& A)
  {
    std::vector<float> entries;
    graph.row_size = graph.column_size = 1;
    graph.num_rows = static_cast<int>(A.rows());
    graph.num_owned = graph.num_columns = static_cast<int>(A.cols());
    graph.first = {0};
    for (int row = 0; row < A.rows(); ++row) {
      for (int column = 0; column < A.cols(); ++column) {
        if (A(row, column) != 0) {
          graph.columns.push_back(column);
          entries.push_back(static_cast<float>(A(row, column)));
        }
      }
      graph.first.push_back(static_cast<int>(graph.columns.size()));
    }
    blocks = makeNumbers<HostBlocks>(entries.size());
    std::copy(entries.begin(), entries.end(), blocks.data());
  }

  HostGraph graph;
  HostBlocks blocks;
};

NodeVector numbers(Eigen::VectorXd const& values)
{
  const auto result = makeNumbers<HostBlocks>(values.size());
  std::copy_n(values.data(), values.size(), result.data());
  return onDevice(result);
}

Eigen::VectorXd valuesOf(NodeVector const& x)
{
  const auto host = toHost(x);
  return Eigen::Map<const Eigen::VectorXf>(host.data(), num_nodes).cast<double>();
}

CoarsestRows allRows(int num_rows)
{
  CoarsestRows rows;
  rows.num_rows = num_rows;
  for (int row = 0; row < num_rows; ++row) {
    rows.places.push_back(row);
  }
  rows.sum = [](double*, int) {}; // there is one rank
  return rows;
}

// How blocks at all nodes act on the coarse level: Q is P.
HostAddedBlocks addedAtAllNodes(HostGraph const& level)
{
  const Matrix Q(prolongator());
  HostAddedBlocks added;
  added.graph = Q.graph;
  added.Q = Q.blocks;
  added.first = {0};
  for (int node = 0; node < num_nodes; ++node) {
    if (node < last) { // one column
      added.couplings.push_back(level.find(node / width, node / width));
    }
    added.first.push_back(static_cast<int>(added.couplings.size()));
  }
  for (int row = 0; row < level.num_rows; ++row) {
    added.rows.push_back(row);
  }
  return added;
}

// How sweeps take their rows.
struct Order
{
  RowOrder order = defaultRowOrder();
  int num_threads = 1;
};

// Where kernels run on the host, colours and any number of chunks can be swept.
std::vector<Order> orders()
{
  if (kernels_run_on_host) {
    return {{RowOrder::chunks, 1}, {RowOrder::chunks, 3}, {RowOrder::colours, 1}};
  }
  return {{RowOrder::colours, 1}};
}

std::shared_ptr<const Hierarchy> twoLevels(double diagonal, Order order)
{
  const Eigen::MatrixXd Z = chain(diagonal), P = prolongator();
  const Matrix fine(Z), between(P), coarse(P.transpose() * Z * P);
  std::vector<HostLevel> levels(2);
  levels[0].graph = fine.graph;
  levels[0].prolongation = between.graph;
  levels[0].P = between.blocks;
  levels[1].graph = coarse.graph;
  levels[1].terms = {coarse.blocks};
  levels[1].added = addedAtAllNodes(coarse.graph);
  return std::make_shared<const Hierarchy>(levels, allRows(coarse.graph.num_rows), order.order,
                                           order.num_threads);
}

// The cycle for a chain with blocks H at all nodes, some of which are removed.
struct Chain
{
  explicit Chain(Order order = {}, double diagonal = 2.01)
      : H("H", num_nodes, 1, 1)
      , removed("removed", num_nodes)
      , hierarchy(twoLevels(diagonal, order))
  {
    const auto H_on_host = Kokkos::create_mirror_view(H);
    const auto removed_on_host = Kokkos::create_mirror_view(removed);
    std::vector<int> dofs;
    for (int node = 0; node < num_nodes; ++node) {
      dofs.push_back(node);
      H_on_host(node, 0, 0) = blockAt(node);
      removed_on_host(node) = isFree(node) || node == last ? 0 : 1;
    }
    Kokkos::deep_copy(H, H_on_host);
    Kokkos::deep_copy(removed, removed_on_host);
    std::vector<char> held(num_nodes, 0);
    held[last] = 1;
    const auto dofs_on_device = indices(dofs);
    cycle =
      std::make_unique<Cycle>(hierarchy, std::vector<double>{1}, Matrix(chain(diagonal)).blocks,
                              held, Cycle::Dofs(dofs_on_device.data(), num_nodes, 1));
  }

  static double blockAt(int node) { return node % 4; }
  static bool isFree(int node) { return node != last && node % 7 != 3; }

  // Z + H on the free nodes.
  static Eigen::MatrixXd matrix()
  {
    Eigen::MatrixXd A = chain();
    for (int i = 0; i < num_nodes; ++i) {
      A(i, i) += blockAt(i);
      for (int j = 0; j < num_nodes; ++j) {
        A(i, j) = isFree(i) && isFree(j) ? A(i, j) : 0;
      }
    }
    return A;
  }

  static Eigen::VectorXd force(int sequence)
  {
    Eigen::VectorXd r(num_nodes);
    for (int i = 0; i < num_nodes; ++i) {
      r(i) = isFree(i) ? std::sin(1. + sequence + i * i) : 0;
    }
    return r;
  }

  struct Result
  {
    Eigen::VectorXd z, image;
  };
  Result run(Eigen::VectorXd const& r) const
  {
    const auto given = makeNumbers(num_nodes);
    cycle->toRows(onNodes(r), 1, given);
    auto const result = cycle->run(given, true);
    return {fromRows(result.z), fromRows(result.image)};
  }
  Eigen::VectorXd fromRows(NodeVector const& x) const
  {
    const NodeView result("result", num_nodes);
    cycle->fromRows(x, 1, result);
    return ofNodes(result);
  }

  static NodeView onNodes(Eigen::VectorXd const& values)
  {
    const NodeView result("values", num_nodes);
    const auto host = Kokkos::create_mirror_view(result);
    std::copy_n(values.data(), num_nodes, host.data());
    Kokkos::deep_copy(result, host);
    return result;
  }
  static Eigen::VectorXd ofNodes(NodeView const& view)
  {
    const auto host = toHost(view);
    return Eigen::Map<const Eigen::VectorXd>(host.data(), num_nodes);
  }

  HessianView H;
  FlagView removed;
  std::shared_ptr<const Hierarchy> hierarchy;
  std::unique_ptr<Cycle> cycle;
};
} // namespace

TEST(Cycle, IsSymmetricAndGivesTheImageOfItsResult)
{
  for (auto order : orders()) {
    const Chain chain(order);
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

// With three threads each of two levels has three chunks and one.
TEST(Schedule, HasAChunkForEachThreadUnlessItIsSmall)
{
  const auto hierarchy = twoLevels(2.01, {RowOrder::chunks, 3});
  EXPECT_EQ(hierarchy->levels()[0].schedule.numParts(), 3);
  EXPECT_EQ(hierarchy->levels()[1].schedule.numParts(), 1);
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

TEST(Cycle, RefusesAnIndefiniteMatrix)
{
  const Chain chain({}, 1.5); // positive on both diagonals
  EXPECT_FALSE(chain.cycle->setup(chain.H, chain.removed));
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
  for (double tolerance : {1e-1, FloatConjugateGradients::certain}) {
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
    Eigen::MatrixXd fine = ::asperity::multigrid::chain();
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
