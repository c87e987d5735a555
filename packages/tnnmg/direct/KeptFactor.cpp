#include "tnnmg/direct/KeptFactor.hpp"

#include "multigrid/FlushDenormals.hpp"

#include <cmath>
#include <type_traits>
#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
// More iterations than this cost more than a new factorisation of a few hundred unknowns.
constexpr int max_iterations = 8;

// The power of two that brings the largest magnitude to between 1/2 and 1; 1 for zero.
template <class Values>
double powerOfTwoFor(Values const& values)
{
  const double largest = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
  if (!(largest > 0) || !std::isfinite(largest)) {
    return 1;
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1, -exponent);
}
} // namespace

template <class Scalar>
KeptFactor<Scalar>::KeptFactor(Eigen::Map<const Eigen::MatrixXd> const& Z,
                               std::vector<std::vector<int>> dofs)
    : scale_(powerOfTwoFor(Z.diagonal()))
    , Z_((scale_ * Z).cast<Scalar>())
    , dofs_(std::move(dofs))
{
}

template <class Scalar>
void KeptFactor<Scalar>::read(NonlinearBlocks const& given)
{
  blocks_ = {toHost(given.hessian), toHost(given.truncated)};
  mask_.setOnes(Z_.rows());
  for (std::size_t node = 0; node < dofs_.size(); ++node) {
    if (blocks_.truncated(node)) {
      for (int dof : dofs_[node]) {
        mask_(dof) = 0;
      }
    }
  }
}

template <class Scalar>
template <class Add>
void KeptFactor<Scalar>::forEachHessianEntry(Add const& add) const
{
  for (std::size_t node = 0; node < dofs_.size(); ++node) {
    if (!blocks_.truncated(node)) {
      for (std::size_t k = 0; k < dofs_[node].size(); ++k) {
        for (std::size_t l = 0; l < dofs_[node].size(); ++l) {
          add(dofs_[node][k], dofs_[node][l],
              static_cast<Scalar>(scale_ * blocks_.hessian(node, k, l)));
        }
      }
    }
  }
}

template <class Scalar>
void KeptFactor<Scalar>::readDiagonal()
{
  diagonal_ = Z_.diagonal();
  forEachHessianEntry([&](int row, int column, Scalar value) {
    diagonal_(row) += row == column ? value : Scalar(0);
  });
}

// Whether a factorisation costs more than to try the diagonal as preconditioner first. The diagonal
// suffices where Z is nearly diagonal, as in the steps of a rupture: radiation damping or mass
// outweigh the stress that a step adds.
template <class Scalar>
bool KeptFactor<Scalar>::prefersDiagonal() const
{
  const double taking_part = mask_.sum();
  const double product = 2. * static_cast<double>(Z_.size());
  return taking_part * taking_part * taking_part / 3 > max_iterations * product;
}

template <class Scalar>
bool KeptFactor<Scalar>::factorise()
{
  factored_.clear();
  std::vector<int> place(Z_.rows(), -1);
  for (int dof = 0; dof < Z_.rows(); ++dof) {
    if (mask_(dof) != 0) {
      place[dof] = static_cast<int>(factored_.size());
      factored_.push_back(dof);
    }
  }
  const int size = static_cast<int>(factored_.size());
  Matrix A(size, size);
  for (int column = 0; column < size; ++column) {
    for (int row = column; row < size; ++row) { // LLT reads the lower triangle alone
      A(row, column) = Z_(factored_[row], factored_[column]);
    }
  }
  readDiagonal();
  forEachHessianEntry(
    [&](int row, int column, Scalar value) { A(place[row], place[column]) += value; });
  if (size > 0) {
    factor_.compute(A);
  }
  has_factor_ = size == 0 || factor_.info() == Eigen::Success;
  return has_factor_;
}

template <class Scalar>
auto KeptFactor<Scalar>::apply(Values const& x) const -> Values
{
  Values y = Z_.template selfadjointView<Eigen::Lower>() * x;
  forEachHessianEntry([&](int row, int column, Scalar value) { y(row) += value * x(column); });
  return y.cwiseProduct(mask_);
}

template <class Scalar>
auto KeptFactor<Scalar>::precondition(Values const& x) const -> Values
{
  Values result = x.cwiseQuotient(diagonal_);
  Values part(factored_.size());
  for (std::size_t i = 0; i < factored_.size(); ++i) {
    part(i) = x(factored_[i]);
  }
  if (!factored_.empty()) {
    factor_.solveInPlace(part);
  }
  for (std::size_t i = 0; i < factored_.size(); ++i) {
    result(factored_[i]) = part(i);
  }
  return result.cwiseProduct(mask_);
}

// Preconditioned conjugate gradients from c = 0 with the kept factor. Neither library fits: Belos
// works on Tpetra's vectors and needs a new solver for each solve, which is too much for a few
// iterations on some hundred unknowns. Eigen's solver does not stop where <r, z> <= 0, which means
// that rounding has made the kept factor useless and a new one is needed.
template <class Scalar>
CorrectionResult KeptFactor<Scalar>::iterate(Values r, double relative_tolerance, Values& c) const
{
  CorrectionResult result;
  const double target = relative_tolerance * static_cast<double>(r.norm());
  c.setZero(r.size());
  Values z = precondition(r);
  Values direction = z;
  Scalar rz = r.dot(z);
  result.converged = r.norm() <= target;
  while (!result.converged && result.iterations < max_iterations && rz > 0) {
    ++result.iterations;
    const Values image = apply(direction);
    const Scalar step = rz / direction.dot(image);
    c += step * direction;
    r -= step * image;
    result.converged = r.norm() <= target;
    z = precondition(r);
    const Scalar rz_next = r.dot(z);
    direction = z + rz_next / rz * direction;
    rz = rz_next;
  }
  return result;
}

template <class Scalar>
CorrectionResult KeptFactor<Scalar>::solve(NonlinearBlocks const& blocks, Eigen::VectorXd const& r,
                                           double relative_tolerance, Eigen::VectorXd& c)
{
  const multigrid::FlushDenormals
    flushed; // a condensed mass decays by orders of magnitude from node to node
  read(blocks);
  // A product with the mask would keep a NaN at entries of r that must not be read.
  const Eigen::VectorXd given = (mask_.array() == 0).select(0, r);
  const double scale = powerOfTwoFor(given);
  const Values right = (scale * given).template cast<Scalar>();
  Values solution;
  CorrectionResult result;
  if (!has_factor_) {
    factored_.clear();
    readDiagonal();
  }
  if (has_factor_ || prefersDiagonal()) {
    result = iterate(right, relative_tolerance, solution);
  }
  if (!result.converged && factorise()) {
    solution = precondition(right);
    // In double precision a solve with the factor is exact enough; in single precision it is
    // checked.
    result.converged =
      std::is_same_v<Scalar, double> ||
      (right - apply(solution)).norm() <= static_cast<Scalar>(relative_tolerance) * right.norm();
  }
  if (result.converged) {
    c = solution.template cast<double>() * (scale_ / scale);
  }
  return result;
}

template class KeptFactor<float>;
template class KeptFactor<double>;
} // namespace asperity::tnnmg::detail
