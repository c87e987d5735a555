#include "tnnmg/Tnnmg.hpp"

#include "FullSolve.hpp"

#include <gtest/gtest.h>

#include <Tpetra_Map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// Nodes whose second component has bounds, as the jump across a fault that may open.
namespace asperity::tnnmg
{
using namespace tnnmg::test;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Interval
{
  double lower = -infinity, upper = infinity;
};

// At each node of all ranks; the velocities of the problems are of the order of 1e-2 m/s.
Interval intervalOf(int node)
{
  const double bound = 5e-3 * pseudorandom(node, 11);
  switch (node % 4) {
  case 0: return {bound, infinity};
  case 1: return {-infinity, bound};
  case 2: return {bound, bound + 1e-3};
  default: return {0, 0};
  }
}

// Roughness of the first of two components, and bounds of the second one. Its loops run on the
// host.
class BoundedNodesOfTest : public NodalProblem
{
public:
  explicit BoundedNodesOfTest(RateProblem const& problem)
  {
    std::vector<double> lower, upper;
    for (int node : problem.model.mine) {
      rough_.push_back(problem.nodes[node]);
      lower.push_back(intervalOf(node).lower);
      upper.push_back(intervalOf(node).upper);
    }
    bounds_ = {true, toDevice(lower, "lower"), toDevice(upper, "upper")};
    first_ = std::make_unique<RoughNodes>(rough_);
  }

  Bounds bounds() const override { return bounds_; }

  int minimise(IndexView const& nodes, ConstNodeView const& curvature, ConstBlockView const& r,
               BlockView const& v) const override
  {
    auto const which = toHost(nodes);
    auto const c = toHost(curvature);
    auto const forces = toHost(r);
    auto const result = toHost(v);
    for (std::size_t i = 0; i < which.extent(0); ++i) {
      const int node = which(i);
      minimiseAt(node, c(node), forces(node, 0), forces(node, 1), &result(node, 0));
    }
    Kokkos::deep_copy(v, result);
    return 0;
  }
  int sweep(IndexView const& nodes, DenseSystem const& system, BlockView const& v) const override
  {
    auto const which = toHost(nodes);
    auto const Z = toHost(system.Z);
    auto const r = toHost(system.r);
    auto const c = toHost(system.curvature);
    auto const result = toHost(v);
    for (std::size_t i = 0; i < which.extent(0); ++i) {
      const int node = which(i);
      const double before[2] = {result(node, 0), result(node, 1)};
      minimiseAt(node, c(node), r(node, 0) + c(node) * before[0], r(node, 1) + c(node) * before[1],
                 &result(node, 0));
      for (std::size_t row = 0; row < Z.extent(0); ++row) {
        for (int k = 0; k < 2; ++k) {
          r(row / 2, row % 2) -= Z(row, 2 * node + k) * (result(node, k) - before[k]);
        }
      }
    }
    Kokkos::deep_copy(v, result);
    Kokkos::deep_copy(system.r, r);
    return 0;
  }
  void linearise(ConstBlockView const& v, BlockView const& gradient, HessianView const& hessian,
                 FlagView const& kinked) const override
  {
    const BlockView g("gradient", rough_.size(), 1);
    const HessianView H("hessian", rough_.size(), 1, 1);
    first_->linearise(firstOf(v), g, H, kinked);
    auto const of_first = toHost(g);
    auto const second = toHost(H);
    auto const all = toHost(gradient);
    auto const blocks = toHost(hessian);
    for (std::size_t node = 0; node < rough_.size(); ++node) {
      all(node, 0) = of_first(node, 0);
      all(node, 1) = 0;
      blocks(node, 0, 0) = second(node, 0, 0);
      blocks(node, 0, 1) = blocks(node, 1, 0) = blocks(node, 1, 1) = 0;
    }
    Kokkos::deep_copy(gradient, all);
    Kokkos::deep_copy(hessian, blocks);
  }
  double slope(ConstBlockView const& v, ConstBlockView const& d, double t) const override
  {
    return first_->slope(firstOf(v), firstOf(d), t);
  }
  EnergyChange difference(ConstBlockView const& v, ConstBlockView const& d) const override
  {
    return first_->difference(firstOf(v), firstOf(d));
  }

private:
  void minimiseAt(int node, double curvature, double along, double across, double* v) const
  {
    const double speed = rough_[node].minimiser(curvature, std::abs(along));
    v[0] = along < 0 ? -speed : speed;
    const double lower = toHost(bounds_.lower)(node), upper = toHost(bounds_.upper)(node);
    v[1] = std::min(std::max(across / curvature, lower), upper);
  }
  static BlockView firstOf(ConstBlockView const& blocks)
  {
    const BlockView result("first", blocks.extent(0), 1);
    auto const from = toHost(blocks);
    auto const to = Kokkos::create_mirror_view(result);
    for (std::size_t node = 0; node < blocks.extent(0); ++node) {
      to(node, 0) = from(node, 0);
    }
    Kokkos::deep_copy(result, to);
    return result;
  }

  std::vector<Roughness> rough_;
  Bounds bounds_;
  std::unique_ptr<RoughNodes> first_;
};

// J in long double, within the bounds.
RateProblem::Energy energyOf(RateProblem const& problem, Eigen::VectorXd const& v)
{
  using Long = long double;
  RateProblem::Energy result;
  const auto add = [&result](Long term) {
    result.value += term;
    result.magnitude += std::abs(term);
  };
  for (int column = 0; column < problem.model.global.outerSize(); ++column) {
    add(-Long(problem.b(column)) * v(column));
    for (Eigen::SparseMatrix<double>::InnerIterator entry(problem.model.global, column); entry;
         ++entry) {
      add(Long(0.5) * v(entry.row()) * entry.value() * v(column));
    }
  }
  for (std::size_t node = 0; node < problem.nodes.size(); ++node) {
    auto const& rough = problem.nodes[node];
    const Long V = std::abs(v(problem.model.nonlinear[node][0])), scale = rough.scale;
    add(rough.threshold * V);
    add(rough.strength * (V * std::asinh(V / scale) - V * V / (std::hypot(V, scale) + scale)));
  }
  return result;
}

// The minimiser by coordinate descent, over all components of all nodes on the Schur complement,
// which another library makes. The components of a node are visited one after the other.
Eigen::VectorXd minimiserOf(RateProblem const& problem)
{
  auto const& model = problem.model;
  const int size = static_cast<int>(model.global.rows());
  std::vector<int> order;
  std::vector<bool> is_kept(size, false);
  for (auto const& rows : model.nonlinear) {
    for (int row : rows) {
      is_kept[row] = true;
    }
  }
  for (int row = 0; row < size; ++row) {
    if (!is_kept[row]) {
      order.push_back(row);
    }
  }
  const int inner = static_cast<int>(order.size()), kept = size - inner;
  for (auto const& rows : model.nonlinear) {
    order.insert(order.end(), rows.begin(), rows.end());
  }
  Eigen::MatrixXd A(size, size);
  Eigen::VectorXd b(size);
  const Eigen::MatrixXd Z(model.global);
  for (int i = 0; i < size; ++i) {
    b(i) = problem.b(order[i]);
    for (int j = 0; j < size; ++j) {
      A(i, j) = Z(order[i], order[j]);
    }
  }
  const Eigen::LDLT<Eigen::MatrixXd> factor(A.topLeftCorner(inner, inner));
  const Eigen::MatrixXd coupling = A.topRightCorner(inner, kept);
  const Eigen::MatrixXd S =
    A.bottomRightCorner(kept, kept) - coupling.transpose() * factor.solve(coupling);
  const Eigen::VectorXd f = b.tail(kept) - coupling.transpose() * factor.solve(b.head(inner));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(kept);
  double change = 1;
  for (int sweep = 0; sweep < 20000 && change > 1e-14 * x.norm(); ++sweep) {
    change = 0;
    for (int row = 0; row < kept; ++row) {
      const int node = row / 2;
      const double before = x(row), r = f(row) - S.row(row).dot(x) + S(row, row) * before;
      if (row % 2 == 0) {
        const double speed = problem.nodes[node].minimiser(S(row, row), std::abs(r));
        x(row) = r < 0 ? -speed : speed;
      } else {
        const auto [lower, upper] = intervalOf(node);
        x(row) = std::min(std::max(r / S(row, row), lower), upper);
      }
      change += std::abs(x(row) - before);
    }
  }
  const Eigen::VectorXd others = factor.solve(b.head(inner) - coupling * x);
  Eigen::VectorXd v(size);
  for (int i = 0; i < size; ++i) {
    v(order[i]) = i < inner ? others(i) : x(i - inner);
  }
  return v;
}

// A start that is beyond bounds at some nodes.
Eigen::VectorXd farAway(RateProblem const& problem)
{
  Eigen::VectorXd v = 0.1 * pseudorandomVector(static_cast<int>(problem.b.size()), 3);
  for (int row : problem.model.constrained) {
    v(row) = 0;
  }
  return v;
}

// How many nodes are at a bound, -1 if one is beyond.
int numAtBounds(RateProblem const& problem, Eigen::VectorXd const& v)
{
  int count = 0;
  for (std::size_t node = 0; node < problem.nodes.size(); ++node) {
    const double value = v(problem.model.nonlinear[node][1]);
    const auto [lower, upper] = intervalOf(static_cast<int>(node));
    if (value < lower || value > upper) {
      return -1;
    }
    count += value == lower || value == upper ? 1 : 0;
  }
  return count;
}
} // namespace

class BoundsCase : public ::testing::TestWithParam<RateProblemOptions>
{
};

TEST_P(BoundsCase, MeetsProjectedCoordinateDescent)
{
  const RateProblem problem(GetParam());
  const auto reference = minimiserOf(problem);
  const int num_nodes = static_cast<int>(problem.nodes.size());
  EXPECT_GE(numAtBounds(problem, reference), num_nodes / 4 + 2);
  EXPECT_LE(numAtBounds(problem, reference), num_nodes - 2);
  const auto check = [&](TnnmgResult const& result, Eigen::VectorXd const& v) {
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.energy_increases, 0);
    EXPECT_LE(problem.energyNorm(v - reference), 1e-9 * problem.energyNorm(reference));
    EXPECT_EQ(numAtBounds(problem, v), numAtBounds(problem, reference));
  };
  const BoundedNodesOfTest nodes(problem);
  for (auto const& start : {atRest(problem), farAway(problem)}) {
    auto v = start;
    check(solveFull(problem, nodes, tight(), v), v);
    if (problem.model.map->getComm()->getSize() == 1) {
      v = start;
      check(solveCondensed(problem, nodes, tight(), v), v);
    }
  }
}

TEST_P(BoundsCase, LowersEnergyInEveryIterationAndStaysWithinBounds)
{
  const RateProblem problem(GetParam());
  const BoundedNodesOfTest nodes(problem);
  auto once = tight();
  once.max_iterations = 1;
  auto v = farAway(problem);
  RateProblem::Energy before;
  for (int iteration = 0; iteration < 15; ++iteration) {
    const auto result = solveFull(problem, nodes, once, v);
    EXPECT_EQ(result.energy_increases, 0);
    EXPECT_GE(numAtBounds(problem, v), 0) << "beyond bounds in iteration " << iteration;
    const auto after = energyOf(problem, v);
    if (iteration > 0) { // the start is beyond bounds
      EXPECT_LE(after.value, before.value + 1e-15L * (after.magnitude + before.magnitude))
        << "iteration " << iteration;
    }
    before = after;
  }
  const auto least = energyOf(problem, minimiserOf(problem));
  EXPECT_NEAR(static_cast<double>(before.value - least.value), 0,
              1e-6 * static_cast<double>(least.magnitude));
}

INSTANTIATE_TEST_SUITE_P(Problems, BoundsCase,
                         ::testing::Values(RateProblemOptions{1e-3, 2, 2, Kind::threshold},
                                           RateProblemOptions{1e-3, 2, 2, Kind::both},
                                           RateProblemOptions{1., 2, 2, Kind::logarithm},
                                           RateProblemOptions{1., 2, 2, Kind::both}));
} // namespace asperity::tnnmg
