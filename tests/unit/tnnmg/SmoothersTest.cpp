#include "ElasticModel.hpp"
#include "multigrid/Cycle.hpp"
#include "multigrid/NodeKernels.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"
#include "tnnmg/hierarchy/MultigridHierarchy.hpp"

#include <Eigen/Dense>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Sweeps on the finest level, on 1 to 3 ranks, against dense algebra that knows of no rank.
namespace asperity::tnnmg
{
using namespace tnnmg::test;
using multigrid::LevelMatrix;
using multigrid::NodeVector;

namespace
{
constexpr int N = 2; // components

// (D + E)^-1 in the order of the level's rows.
multigrid::NodeBlocks inverseBlocks(LevelMatrix const& matrix)
{
  auto const& graph = matrix.level.graph;
  const auto A = toHost(matrix.A);
  const auto diagonal = toHost(graph.diagonal);
  const auto E = toHost(matrix.damping);
  const auto inverse = multigrid::makeNumbers<multigrid::HostBlocks>(graph.rows() * N);
  for (int row = 0; row < graph.num_rows; ++row) {
    double block[N][N];
    for (int i = 0; i < N * N; ++i) {
      block[i / N][i % N] = A(static_cast<std::size_t>(diagonal(row)) * N * N + i);
    }
    for (int c = 0; c < N && E.extent(0) > 0; ++c) {
      block[c][c] += E(row * N + c);
    }
    multigrid::invertFree(block, multigrid::AllFree(), inverse.data() + row * N * N);
  }
  return multigrid::onDevice(inverse);
}

struct Sweep
{
  Eigen::VectorXd x, residual;
};

// Of a smoother from zero, with Z as its matrix: no dof is held.
Sweep sweepFromZero(ElasticModel const& model, std::string const& name, Eigen::VectorXd const& b)
{
  const MultigridTerms terms({[&] { return model.Z; }}, model.problem(),
                             Teuchos::ParameterList("Linear Correction"));
  auto const& hierarchy = terms.hierarchy();
  auto const& level = hierarchy.levels().front();
  const auto blocks = hierarchy.finestBlocks(*model.Z);
  LevelMatrix matrix = {level, hierarchy.shared()->inOrder(blocks), {}, {},
                        {},    hierarchy.shared()->coarsest().sum};
  const auto smoother = multigrid::SmootherRegistry::instance().at(name).make();
  smoother->damp(matrix);
  matrix.inverse = inverseBlocks(matrix);
  smoother->matrixChanged(matrix);
  // Only for the numbers of its rows.
  const multigrid::Cycle cycle(hierarchy.shared(), {1}, blocks,
                               std::vector<char>(numLocalRows(*model.Z), 0), {});
  const auto given = multigrid::makeNumbers(level.graph.rows());
  const auto x = multigrid::makeNumbers(level.graph.columnsWithGhosts());
  const auto residual = multigrid::makeNumbers(level.graph.rows());
  const auto column = [](auto const& view) { return Kokkos::subview(view, Kokkos::ALL(), 0); };
  const Vector scattered = model.scatter(b);
  cycle.toRows(column(scattered.getLocalViewDevice(Tpetra::Access::ReadOnly)), 1, given);
  smoother->presmooth(matrix, given, x, residual);
  const auto gathered = [&](NodeVector const& rows) {
    Vector result(model.map);
    cycle.fromRows(rows, 1, column(result.getLocalViewDevice(Tpetra::Access::OverwriteAll)));
    return model.gather(result);
  };
  return {gathered(x), gathered(residual)};
}

Eigen::MatrixXd blockDiagonal(Eigen::MatrixXd const& A)
{
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(A.rows(), A.cols());
  for (int i = 0; i < A.rows(); i += N) {
    D.block<N, N>(i, i) = A.block<N, N>(i, i);
  }
  return D;
}

ElasticModel model()
{
  ElasticModelOptions options;
  options.cells_x = 20;
  options.tau = 1;
  return ElasticModel(options);
}
} // namespace

// (D + E)^-1 b with the E of the declaration of DampRow for t = 4/3 and all couplings in G; the
// largest eigenvalue of (D + E)^-1 A is then at most 4/3.
TEST(Smoothers, BlockJacobiIsTheSameOnAnyNumberOfRanks)
{
  const auto gelatine = model();
  const Eigen::MatrixXd A(gelatine.global), D = blockDiagonal(A);
  Eigen::MatrixXd damped = D;
  const Eigen::VectorXd scale = A.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * A * scale.asDiagonal();
  for (int i = 0; i < A.rows(); i += N) {
    const double least =
      1 / scaled.block<N, N>(i, i).inverse().cwiseAbs().rowwise().sum().maxCoeff();
    for (int r = i; r < i + N; ++r) {
      const double outside =
        scaled.row(r).cwiseAbs().sum() - scaled.block<1, N>(r, i).cwiseAbs().sum();
      damped(r, r) += std::max(0., (outside - least / 3) * 0.75) * A(r, r);
    }
  }
  const Eigen::VectorXd b = pseudorandomVector(static_cast<int>(A.rows()), 3);
  const Eigen::VectorXd expected = damped.ldlt().solve(b);
  const auto [x, residual] = sweepFromZero(gelatine, "Block Jacobi", b);
  EXPECT_LE((x - expected).norm(), 1e-5 * expected.norm());
  EXPECT_LE((b - A * x - residual).norm(), 1e-5 * b.norm());
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(A, damped,
                                                                        Eigen::EigenvaluesOnly);
  EXPECT_LE(eigen.eigenvalues().maxCoeff(), 4. / 3);
}

// 4 / t (u - 4 / (5 t) w) with u = D^-1 b, w = D^-1 A u and t = 2.894: the largest eigenvalue of
// D^-1 A is less than t by more than a tenth, so that E is zero. With an E that is not,
// Cycle.IsPositiveHoweverStronglyChunksAreCoupled has such a matrix.
TEST(Smoothers, ChebyshevIsTheSameOnAnyNumberOfRanks)
{
  const auto gelatine = model();
  const Eigen::MatrixXd A(gelatine.global), D = blockDiagonal(A);
  const double t = 2 / (1 - std::cos(2 * M_PI / 5));
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(A, D,
                                                                        Eigen::EigenvaluesOnly);
  ASSERT_LT(1.1 * eigen.eigenvalues().maxCoeff(), t);
  const Eigen::LDLT<Eigen::MatrixXd> solver(D);
  const Eigen::VectorXd b = pseudorandomVector(static_cast<int>(A.rows()), 3);
  const Eigen::VectorXd u = solver.solve(b), w = solver.solve(A * u);
  const Eigen::VectorXd expected = 4 / t * u - 3.2 / (t * t) * w;
  const auto [x, residual] = sweepFromZero(gelatine, "Chebyshev", b);
  EXPECT_LE((x - expected).norm(), 1e-5 * expected.norm());
  EXPECT_LE((b - A * x - residual).norm(), 1e-5 * b.norm());
}
} // namespace asperity::tnnmg
