#include "FaultState.hpp"

#include <cmath>

namespace asperity::tnnmg::test
{
namespace
{
Eigen::MatrixXd randomHessian(int node, int tangents, double lowest, double highest)
{
  const double exponent = lowest + 0.5 * (1 + pseudorandom(node, 1)) * (highest - lowest);
  const double stiffest = std::pow(10.0, exponent);
  if (tangents == 1) {
    return Eigen::MatrixXd::Constant(1, 1, stiffest);
  }
  // Up to 1000 times softer in one direction, as friction is along the slip.
  const double softer = std::pow(10.0, -1.5 * (1 + pseudorandom(node, 3)));
  const Eigen::Matrix2d frame = Eigen::Rotation2Dd(3 * pseudorandom(node, 2)).toRotationMatrix();
  return stiffest * frame * Eigen::Vector2d(1, softer).asDiagonal() * frame.transpose();
}

bool isTruncated(int node, int num_nodes, Truncation truncation)
{
  switch (truncation) {
  case Truncation::none: return false;
  case Truncation::every_second: return node % 2 == 1;
  case Truncation::left_half: return node < num_nodes / 2;
  case Truncation::all: return true;
  }
  return false;
}
} // namespace

FaultState::FaultState(ElasticModel const& model, Truncation truncation, double lowest,
                       double highest)
{
  const int num_nodes = static_cast<int>(model.nonlinear.size());
  for (int node = 0; node < num_nodes; ++node) {
    const int first = model.nonlinear[node][0];
    const double diagonal = model.global.coeff(first, first);
    hessian.emplace_back(diagonal * randomHessian(node, model.options.tangents, lowest, highest));
    truncated.push_back(isTruncated(node, num_nodes, truncation));
  }
}

NonlinearBlocks FaultState::blocks(ElasticModel const& model) const
{
  const int tangents = model.options.tangents;
  Kokkos::View<double***, Kokkos::LayoutRight, MemorySpace> hessians("hessian", model.mine.size(),
                                                                     tangents, tangents);
  Kokkos::View<int*, MemorySpace> flags("truncated", model.mine.size());
  auto host_hessians = Kokkos::create_mirror_view(hessians);
  auto host_flags = Kokkos::create_mirror_view(flags);
  for (std::size_t k = 0; k < model.mine.size(); ++k) {
    const int node = model.mine[k];
    host_flags(k) = truncated[node];
    for (int s = 0; s < tangents; ++s) {
      for (int t = 0; t < tangents; ++t) {
        host_hessians(k, s, t) = truncated[node] ? std::nan("") : hessian[node](s, t);
      }
    }
  }
  Kokkos::deep_copy(hessians, host_hessians);
  Kokkos::deep_copy(flags, host_flags);
  return {hessians, flags};
}

Eigen::SparseMatrix<double> FaultState::matrix(ElasticModel const& model) const
{
  Eigen::SparseMatrix<double> result = model.global;
  std::vector<bool> out(result.rows(), false);
  for (std::size_t node = 0; node < hessian.size(); ++node) {
    for (int s = 0; s < hessian[node].rows(); ++s) {
      out[model.nonlinear[node][s]] = truncated[node];
      for (int t = 0; t < hessian[node].cols() && !truncated[node]; ++t) {
        result.coeffRef(model.nonlinear[node][s], model.nonlinear[node][t]) += hessian[node](s, t);
      }
    }
  }
  decouple(result, out);
  return result;
}

Eigen::VectorXd FaultState::project(ElasticModel const& model, Eigen::VectorXd vector) const
{
  for (int row : model.constrained) {
    vector(row) = 0;
  }
  for (std::size_t node = 0; node < truncated.size(); ++node) {
    for (int row : model.nonlinear[node]) {
      vector(row) = truncated[node] ? 0.0 : vector(row);
    }
  }
  return vector;
}
} // namespace asperity::tnnmg::test
