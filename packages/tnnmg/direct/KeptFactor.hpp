#pragma once

#include "tnnmg/LinearCorrection.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace asperity::tnnmg::detail
{
// (Z + H) c = r on the dofs that take part, for a dense Z in the given precision: conjugate
// gradients with a kept Cholesky factor of an earlier Z + H, or with the diagonal. Z and r are
// scaled by powers of two, so that single precision neither overflows nor loses what is small.
template <class Scalar>
class KeptFactor
{
public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Values = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  // dofs: rows of Z at each of the nonlinear nodes.
  KeptFactor(Eigen::Map<const Eigen::MatrixXd> const& Z, std::vector<std::vector<int>> dofs);

  // Solves until the residual, relative to r in the Euclidean norm, is at most the tolerance; c is
  // zero at truncated nodes, where r is not read. If the result has not converged, c is not
  // set: Z + H is not positive definite, or too ill-conditioned for the precision.
  CorrectionResult solve(NonlinearBlocks const& blocks, Eigen::VectorXd const& r,
                         double relative_tolerance, Eigen::VectorXd& c);
  void forgetFactor() { has_factor_ = false; }

private:
  // The factor is Eigen's, on the host; where nodes live on a device, their blocks are copied. They
  // belong to the nodes of the fault alone.
  template <class View>
  using HostCopy = decltype(toHost(std::declval<View>()));

  void read(NonlinearBlocks const& given);
  void readDiagonal();
  bool prefersDiagonal() const;
  bool factorise();
  Values apply(Values const& x) const;
  Values precondition(Values const& x) const;
  CorrectionResult iterate(Values r, double relative_tolerance, Values& c) const;
  template <class Add>
  void forEachHessianEntry(Add const& add) const;

  double scale_; // of Z
  Matrix Z_;
  std::vector<std::vector<int>> dofs_;

  // The factor of Z + H on the dofs that took part when it was made; the other dofs have their
  // diagonal. In the long time between earthquakes most nodes are too stiff to take part. Without a
  // factor all dofs have their diagonal.
  Eigen::LLT<Matrix> factor_;
  std::vector<int> factored_;
  Values diagonal_;
  bool has_factor_ = false;

  // The Hessians of the current solve by node; mask_ is 1 on the dofs that take part, else 0.
  struct
  {
    HostCopy<decltype(NonlinearBlocks::hessian)> hessian;
    HostCopy<decltype(NonlinearBlocks::truncated)> truncated;
  } blocks_;
  Values mask_;
};

extern template class KeptFactor<float>;
extern template class KeptFactor<double>;
} // namespace asperity::tnnmg::detail
