#include "multigrid/Cycle.hpp"

#include "multigrid/CoarsestSolver.hpp"
#include "multigrid/FloatConjugateGradients.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

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
    graph.row_size = graph.column_size = 1;
    graph.num_rows = static_cast<int>(A.rows());
    graph.num_owned = graph.num_columns = static_cast<int>(A.cols());
    graph.first = {0};
    for (int row = 0; row < A.rows(); ++row) {
      for (int column = 0; column < A.cols(); ++column) {
        if (A(row, column) != 0) {
          graph.columns.push_back(column);
          blocks.push_back(static_cast<float>(A(row, column)));
        }
      }
      graph.first.push_back(static_cast<int>(graph.columns.size()));
    }
  }

  NodeGraph graph;
  NodeBlocks blocks;
};

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
AddedBlocks addedAtAllNodes(NodeGraph const& level)
{
  const Matrix Q(prolongator());
  AddedBlocks added;
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

std::shared_ptr<const Hierarchy> twoLevels(double diagonal, int num_threads)
{
  const Eigen::MatrixXd Z = chain(diagonal), P = prolongator();
  const Matrix fine(Z), between(P), coarse(P.transpose() * Z * P);
  const auto hierarchy = std::make_shared<Hierarchy>();
  hierarchy->levels.resize(2);
  auto& first = hierarchy->levels[0];
  first.graph = fine.graph;
  first.prolongation = between.graph;
  first.P = between.blocks;
  first.complete(num_threads);
  auto& second = hierarchy->levels[1];
  second.graph = coarse.graph;
  second.terms = {coarse.blocks};
  second.added = addedAtAllNodes(coarse.graph);
  second.complete(num_threads);
  hierarchy->coarsest = allRows(coarse.graph.num_rows);
  return hierarchy;
}

// The cycle for a chain with blocks H at all nodes, some of which are removed.
struct Chain
{
  explicit Chain(double diagonal = 2.01, int num_threads = 1)
      : H("H", num_nodes, 1, 1)
      , removed("removed", num_nodes)
      , dofs("dofs", num_nodes, 1)
      , hierarchy(twoLevels(diagonal, num_threads))
  {
    for (int node = 0; node < num_nodes; ++node) {
      dofs(node, 0) = node;
      H(node, 0, 0) = node % 4;
      removed(node) = node % 7 == 3;
    }
    std::vector<char> held(num_nodes, 0);
    held[last] = 1;
    cycle = std::make_unique<Cycle>(hierarchy, std::vector<double>{1},
                                    Matrix(chain(diagonal)).blocks, held, dofs);
  }

  bool isFree(int node) const { return node != last && !removed(node); }

  // Z + H on the free nodes.
  Eigen::MatrixXd matrix() const
  {
    Eigen::MatrixXd A = chain();
    for (int i = 0; i < num_nodes; ++i) {
      A(i, i) += H(i, 0, 0);
      for (int j = 0; j < num_nodes; ++j) {
        A(i, j) = isFree(i) && isFree(j) ? A(i, j) : 0;
      }
    }
    return A;
  }

  Eigen::VectorXd force(int sequence) const
  {
    Eigen::VectorXd r(num_nodes);
    for (int i = 0; i < num_nodes; ++i) {
      r(i) = isFree(i) ? std::sin(1. + sequence + i * i) : 0;
    }
    return r;
  }

  Cycle::Result run(Eigen::VectorXd const& r) const
  {
    return cycle->run(NodeVector(r.data(), r.data() + r.size()), true);
  }

  HostView<double***> H;
  HostView<int*> removed;
  HostView<int**> dofs;
  std::shared_ptr<const Hierarchy> hierarchy;
  std::unique_ptr<Cycle> cycle;
};

Eigen::VectorXd valuesOf(NodeVector const& x)
{
  return Eigen::Map<const Eigen::VectorXf>(x.data(), num_nodes).cast<double>();
}
} // namespace

namespace
{
void expectSymmetryAndImage(Chain const& chain)
{
  ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
  const auto A = chain.matrix();
  const auto r = chain.force(0), q = chain.force(1);
  const auto of_r = chain.run(r);
  const auto z = valuesOf(of_r.z), image = valuesOf(of_r.image);
  for (int node = 0; node < num_nodes; ++node) {
    EXPECT_EQ(z(node) != 0, chain.isFree(node)) << node;
  }
  EXPECT_LE((A * z - image).norm(), 1e-5 * image.norm());
  const auto y = valuesOf(chain.run(q).z);
  EXPECT_NEAR(z.dot(q), y.dot(r), 1e-5 * z.norm() * q.norm());
  EXPECT_GT(z.dot(r), 0);
}
} // namespace

TEST(Cycle, IsSymmetricAndGivesTheImageOfItsResult) { expectSymmetryAndImage(Chain()); }

// With three threads each of two levels has three chunks and one.
TEST(Cycle, IsSymmetricAndGivesTheImageOfItsResultOnThreads)
{
  const Chain chain(2.01, 3);
  EXPECT_EQ(chain.hierarchy->levels[0].chunks.count(), 3);
  EXPECT_EQ(chain.hierarchy->levels[1].chunks.count(), 1);
  expectSymmetryAndImage(chain);
}

// One more number of threads changes the sweep, but not what the iteration reaches.
TEST(FloatConjugateGradients, NeedAboutAsManyIterationsOnThreads)
{
  std::vector<int> iterations;
  for (int num_threads : {1, 2, 3}) {
    const Chain chain(2.01, num_threads);
    const std::vector<double> blocks(chain.H.data(), chain.H.data() + chain.H.size());
    chain.cycle->setCoarseBlocks(blocks);
    ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
    FloatConjugateGradients gradients(*chain.cycle, [](double*, int) {});
    const auto r = chain.force(0);
    Eigen::VectorXd c(num_nodes);
    const HostView<const double*> from(r.data(), num_nodes);
    const HostView<double*> to(c.data(), num_nodes);
    const auto result = gradients.solve(from, r.norm(), 1e-3, 100, to);
    EXPECT_TRUE(result.converged);
    EXPECT_LE((r - chain.matrix() * c).norm(), 1.01e-3 * r.norm());
    iterations.push_back(result.iterations);
  }
  // A chain is cut at one node of 300: the sweep differs there alone.
  EXPECT_LE(iterations[1], iterations[0] + 1);
  EXPECT_LE(iterations[2], iterations[0] + 1);
}

TEST(Cycle, RefusesAnIndefiniteMatrix)
{
  const Chain chain(1.5); // positive on both diagonals
  EXPECT_FALSE(chain.cycle->setup(chain.H, chain.removed));
}

TEST(FloatConjugateGradients, SolveToTheirTolerance)
{
  const Chain chain;
  std::vector<double> blocks(chain.H.data(), chain.H.data() + chain.H.size());
  chain.cycle->setCoarseBlocks(blocks);
  ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
  int reductions = 0;
  FloatConjugateGradients gradients(*chain.cycle, [&](double*, int) { ++reductions; });
  auto r = chain.force(0);
  Eigen::VectorXd c(num_nodes);
  const HostView<const double*> from(r.data(), num_nodes);
  const HostView<double*> to(c.data(), num_nodes);
  for (double tolerance : {1e-1, FloatConjugateGradients::certain}) {
    reductions = 0;
    const auto result = gradients.solve(from, r.norm(), tolerance, 100, to);
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(reductions, result.iterations) << "one in each iteration";
    EXPECT_LE((r - chain.matrix() * c).norm(), 1.01 * tolerance * r.norm());
  }
  EXPECT_FALSE(gradients.solve(from, r.norm(), 1e-3, 1, to).converged);
  r.setZero();
  EXPECT_TRUE(gradients.solve(from, 0, 1e-3, 100, to).converged);
  EXPECT_EQ(c.norm(), 0);
}

// The energy of a coarse function is that of the fine function that it stands for.
TEST(AddedBlocks, AreAGalerkinProduct)
{
  const Chain chain;
  auto const& level = chain.hierarchy->levels[1];
  auto A = level.terms[0];
  const std::vector<double> blocks(chain.H.data(), chain.H.data() + chain.H.size());
  level.added.addTo(A, blocks);
  Eigen::MatrixXd fine = ::asperity::multigrid::chain();
  fine.diagonal() += Eigen::Map<const Eigen::VectorXd>(blocks.data(), num_nodes);
  const Eigen::MatrixXd expected = prolongator().transpose() * fine * prolongator();
  for (int row = 0; row < level.graph.num_rows; ++row) {
    for (int k = level.graph.first[row]; k < level.graph.first[row + 1]; ++k) {
      EXPECT_NEAR(A[k], expected(row, level.graph.columns[k]), 1e-6);
    }
  }
}

TEST(CoarsestSolver, LeavesOutWhatIsNotFree)
{
  const Matrix A(chain());
  std::vector<char> free(num_nodes, 1);
  free[5] = free[20] = 0;
  const auto solver = CoarsestSolver::make(A.graph, allRows(num_nodes), A.blocks, free);
  ASSERT_TRUE(solver);
  Eigen::MatrixXd part = chain();
  Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(num_nodes, 1, 2);
  NodeVector x(num_nodes), given(b.data(), b.data() + num_nodes);
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
  EXPECT_EQ(x[5], 0);
}
} // namespace asperity::multigrid
