#include "RateProblem.hpp"

#include <Tpetra_Map.hpp>

#include <algorithm>
#include <ostream>

namespace asperity::tnnmg::test
{
namespace
{
using Long = long double;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;

ElasticModelOptions modelOptions(RateProblemOptions const& options)
{
  ElasticModelOptions result;
  result.cells_x = 16;
  result.cells_y = 4;
  result.tau = options.tau;
  result.components = options.components;
  result.tangents = options.tangents;
  result.walls = options.walls;
  return result;
}

std::vector<int> sort(int size, std::vector<std::vector<int>> const& last)
{
  std::vector<bool> is_last(size, false);
  std::vector<int> order;
  for (auto const& rows : last) {
    for (int row : rows) {
      is_last[row] = true;
    }
  }
  for (int row = 0; row < size; ++row) {
    if (!is_last[row]) {
      order.push_back(row);
    }
  }
  for (auto const& rows : last) {
    order.insert(order.end(), rows.begin(), rows.end());
  }
  return order;
}

// Z and b with the rows of the nodes last, and what is left of them there when the others follow.
struct Condensed
{
  Condensed(Eigen::SparseMatrix<double> const& Z, Eigen::VectorXd const& right_side,
            std::vector<std::vector<int>> const& nodes)
      : order(sort(static_cast<int>(Z.rows()), nodes))
  {
    const auto size = Z.rows();
    LongMatrix A(size, size);
    LongVector b(size);
    for (int i = 0; i < size; ++i) {
      b(i) = right_side(order[i]);
      for (int j = 0; j < size; ++j) {
        A(i, j) = Z.coeff(order[i], order[j]);
      }
    }
    for (auto const& rows : nodes) {
      num_kept += static_cast<int>(rows.size());
    }
    const auto inner = size - num_kept;
    const LongMatrix right = A.topRightCorner(inner, num_kept);
    const Eigen::LDLT<LongMatrix> factor(A.topLeftCorner(inner, inner));
    inner_from_kept = -factor.solve(right);
    inner_at_rest = factor.solve(b.head(inner));
    S = A.bottomRightCorner(num_kept, num_kept) + right.transpose() * inner_from_kept;
    f = b.tail(num_kept) - right.transpose() * inner_at_rest;
  }

  Eigen::VectorXd expand(LongVector const& kept) const
  {
    const LongVector inner = inner_at_rest + inner_from_kept * kept;
    Eigen::VectorXd v(inner.size() + kept.size());
    for (int i = 0; i < v.size(); ++i) {
      v(order[i]) = static_cast<double>(i < inner.size() ? inner(i) : Long(kept(i - inner.size())));
    }
    return v;
  }

  std::vector<int> order;
  int num_kept = 0;
  LongMatrix S, inner_from_kept;
  LongVector f, inner_at_rest;
};

// A push that changes its direction along the fault.
Eigen::VectorXd push(ElasticModel const& model)
{
  const int components = model.options.components;
  Eigen::VectorXd target(model.global.rows());
  for (int dof = 0; dof < target.size(); ++dof) {
    const int column = dof / components / (model.options.cells_y + 1);
    target(dof) = 1e-2 * std::cos(0.3 * column + 2 * (dof % components));
  }
  Eigen::VectorXd b = model.global * target;
  for (int row : model.constrained) {
    b(row) = 0;
  }
  return b;
}
} // namespace

void PrintTo(RateProblemOptions const& options, std::ostream* out)
{
  static const char* names[] = {"threshold", "logarithm", "both"};
  *out << "tau " << options.tau << " s, " << options.components << " components, "
       << options.tangents << " tangents, " << names[static_cast<int>(options.kind)];
}

RateProblem::RateProblem(RateProblemOptions const& options)
    : model(modelOptions(options))
    , b(push(model))
{
  // The force that holds each node if none moves; the thresholds lie around its average.
  const Condensed condensed(model.global, b, model.nonlinear);
  const int tangents = options.tangents;
  double average = 0;
  for (std::size_t node = 0; node < model.nonlinear.size(); ++node) {
    average += static_cast<double>(condensed.f.segment(node * tangents, tangents).norm());
  }
  average /= static_cast<double>(model.nonlinear.size());
  for (std::size_t node = 0; node < model.nonlinear.size(); ++node) {
    const double scatter = 1 + 0.7 * pseudorandom(static_cast<int>(node), 7);
    Roughness rough;
    rough.threshold = options.kind == Kind::logarithm ? 0 : 0.95 * average * scatter;
    rough.strength = options.kind == Kind::threshold ? 0 : 0.05 * average * scatter;
    rough.scale = 1e-9;
    nodes.push_back(rough);
  }
}

RoughNodes RateProblem::nodesOfRank() const
{
  std::vector<Roughness> mine;
  for (int node : model.mine) {
    mine.push_back(nodes[node]);
  }
  return RoughNodes(mine);
}

std::vector<std::vector<int>> RateProblem::heldOnRank(std::map<int, double> const& held) const
{
  std::vector<std::vector<int>> flags;
  auto const& walls = model.options.walls;
  for (int node : model.mine) {
    flags.emplace_back(model.options.tangents, static_cast<int>(held.count(node)));
    if (std::find(walls.begin(), walls.end(), node) != walls.end()) {
      flags.back()[1] = 1;
    }
  }
  return flags;
}

RateProblem::Energy RateProblem::energy(Eigen::VectorXd const& v) const
{
  Energy result;
  const auto add = [&result](Long term) {
    result.value += term;
    result.magnitude += std::abs(term);
  };
  for (int column = 0; column < model.global.outerSize(); ++column) {
    add(-Long(b(column)) * v(column));
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.global, column); entry; ++entry) {
      add(Long(0.5) * v(entry.row()) * entry.value() * v(column));
    }
  }
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    Long square = 0;
    for (int row : model.nonlinear[node]) {
      square += Long(v(row)) * v(row);
    }
    const Long V = std::sqrt(square);
    const Long scale = nodes[node].scale;
    add(nodes[node].threshold * V);
    add(nodes[node].strength *
        (V * std::asinh(V / scale) - square / (std::hypot(V, scale) + scale)));
  }
  return result;
}

double RateProblem::energyNorm(Eigen::VectorXd const& v) const
{
  return std::sqrt(std::max(v.dot(model.global * v), 0.));
}

Eigen::VectorXd RateProblem::reference(std::map<int, double> const& held) const
{
  const Condensed condensed(model.global, b, model.nonlinear);
  const int T = model.options.tangents;
  LongVector v = LongVector::Zero(condensed.num_kept);
  for (auto const& [node, value] : held) {
    v(node * T) = value;
  }
  auto const& walls = model.options.walls;
  std::vector<Long> curvature;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const LongMatrix block = condensed.S.block(node * T, node * T, T, T);
    curvature.push_back(Eigen::SelfAdjointEigenSolver<LongMatrix>(block).eigenvalues().maxCoeff());
  }
  Long change = 1;
  for (int sweep = 0; sweep < 100000 && change > 0; ++sweep) {
    change = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (held.count(static_cast<int>(i))) {
        continue;
      }
      const LongVector before = v.segment(i * T, T);
      LongVector r = condensed.f.segment(i * T, T) - condensed.S.middleRows(i * T, T) * v +
                     curvature[i] * before;
      if (std::find(walls.begin(), walls.end(), i) != walls.end()) {
        r(1) = 0;
      }
      const Long size = r.norm();
      const Long speed = nodes[i].minimiser(curvature[i], size);
      v.segment(i * T, T) = speed > 0 ? LongVector(r / size * speed) : LongVector::Zero(T);
      change += (v.segment(i * T, T) - before).norm();
    }
    change = change < Long(1e-18) * v.norm() ? 0 : change;
  }
  return condensed.expand(v);
}
} // namespace asperity::tnnmg::test
