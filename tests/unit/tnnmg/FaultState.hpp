#pragma once

#include "ElasticModel.hpp"

#include <Eigen/Dense>

#include <vector>

namespace asperity::tnnmg::test
{
enum class Truncation
{
  none,
  every_second,
  left_half,
  all
};

// Hessians between 10^lowest and 10^highest of Z's diagonal, pseudorandom from node to node, and a
// truncation.
struct FaultState
{
  FaultState(ElasticModel const& model, Truncation truncation, double lowest = -2,
             double highest = 12);

  NonlinearBlocks blocks(ElasticModel const& model) const;

  // (Z + H) without truncated and constrained rows and columns, which are replaced by the identity.
  Eigen::SparseMatrix<double> matrix(ElasticModel const& model) const;
  // Zero at these.
  Eigen::VectorXd project(ElasticModel const& model, Eigen::VectorXd vector) const;

  std::vector<Eigen::MatrixXd> hessian; // of all fault nodes, on every rank
  std::vector<int> truncated;
};
} // namespace asperity::tnnmg::test
