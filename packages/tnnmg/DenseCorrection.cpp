#include "tnnmg/DenseCorrection.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::tnnmg
{
namespace
{
// More iterations than this cost more than a new factorisation of a few hundred unknowns.
constexpr int max_iterations = 8;
} // namespace

// The factor is Eigen's, on the host; where nodes live on a device, their blocks are copied. They
// belong to the nodes of the fault alone.
template <class View>
using HostCopy = decltype(toHost(std::declval<View>()));

struct DenseCorrection::Implementation
{
  Eigen::MatrixXd Z;
  std::vector<std::vector<int>> dofs; // of each node

  // The factor of Z + H on the dofs that took part when it was made; the other dofs have their
  // diagonal. In the long time between earthquakes most nodes are too stiff to take part. Without a
  // factor all dofs have their diagonal.
  Eigen::LLT<Eigen::MatrixXd> factor;
  std::vector<int> factored;
  Eigen::VectorXd diagonal;
  bool has_factor = false;

  // The current solve has H by node, and 1 on the dofs that take part.
  struct
  {
    HostCopy<decltype(NonlinearBlocks::hessian)> hessian;
    HostCopy<decltype(NonlinearBlocks::truncated)> truncated;
  } blocks;
  Eigen::VectorXd mask;

  void read(NonlinearBlocks const& given)
  {
    blocks = {toHost(given.hessian), toHost(given.truncated)};
    mask.setOnes(Z.rows());
    for (std::size_t node = 0; node < dofs.size(); ++node) {
      if (blocks.truncated(node)) {
        for (int dof : dofs[node]) {
          mask(dof) = 0;
        }
      }
    }
  }

  template <class Add>
  void forEachHessianEntry(Add const& add) const
  {
    for (std::size_t node = 0; node < dofs.size(); ++node) {
      if (!blocks.truncated(node)) {
        for (std::size_t k = 0; k < dofs[node].size(); ++k) {
          for (std::size_t l = 0; l < dofs[node].size(); ++l) {
            add(dofs[node][k], dofs[node][l], blocks.hessian(node, k, l));
          }
        }
      }
    }
  }

  void readDiagonal()
  {
    diagonal = Z.diagonal();
    forEachHessianEntry(
      [&](int row, int column, double value) { diagonal(row) += row == column ? value : 0; });
  }

  // In the steps of a rupture Z is nearly diagonal: radiation damping or mass outweigh the stress
  // that a step adds. Whether a factor costs more than to try without one.
  bool isWorthTryingDiagonal() const
  {
    const double taking_part = mask.sum();
    const double product = 2. * static_cast<double>(Z.size());
    return taking_part * taking_part * taking_part / 3 > max_iterations * product;
  }

  bool factorise()
  {
    factored.clear();
    std::vector<int> place(Z.rows(), -1);
    for (int dof = 0; dof < Z.rows(); ++dof) {
      if (mask(dof) != 0) {
        place[dof] = static_cast<int>(factored.size());
        factored.push_back(dof);
      }
    }
    const int size = static_cast<int>(factored.size());
    Eigen::MatrixXd A(size, size);
    for (int column = 0; column < size; ++column) {
      for (int row = 0; row < size; ++row) {
        A(row, column) = Z(factored[row], factored[column]);
      }
    }
    readDiagonal();
    forEachHessianEntry(
      [&](int row, int column, double value) { A(place[row], place[column]) += value; });
    if (size > 0) {
      factor.compute(A);
    }
    has_factor = size == 0 || factor.info() == Eigen::Success;
    return has_factor;
  }

  Eigen::VectorXd apply(Eigen::VectorXd const& x) const
  {
    Eigen::VectorXd y = Z.selfadjointView<Eigen::Lower>() * x;
    forEachHessianEntry([&](int row, int column, double value) { y(row) += value * x(column); });
    return y.cwiseProduct(mask);
  }

  Eigen::VectorXd precondition(Eigen::VectorXd const& x) const
  {
    Eigen::VectorXd result = x.cwiseQuotient(diagonal);
    Eigen::VectorXd part(factored.size());
    for (std::size_t i = 0; i < factored.size(); ++i) {
      part(i) = x(factored[i]);
    }
    if (!factored.empty()) {
      factor.solveInPlace(part);
    }
    for (std::size_t i = 0; i < factored.size(); ++i) {
      result(factored[i]) = part(i);
    }
    return result.cwiseProduct(mask);
  }

  // Preconditioned conjugate gradients from c = 0 with the kept factor. By hand: Belos works on
  // Tpetra's vectors and wants a new solver for each solve, too much for a few iterations on some
  // hundred unknowns; Eigen's do not stop where <r, z> <= 0, that is where rounding has spoilt the
  // kept factor and a new one is due.
  CorrectionResult iterate(Eigen::VectorXd r, double relative_tolerance, Eigen::VectorXd& c) const
  {
    CorrectionResult result;
    const double target = relative_tolerance * r.norm();
    c.setZero(r.size());
    Eigen::VectorXd z = precondition(r);
    Eigen::VectorXd direction = z;
    double rz = r.dot(z);
    result.converged = r.norm() <= target;
    while (!result.converged && result.iterations < max_iterations && rz > 0) {
      ++result.iterations;
      const Eigen::VectorXd image = apply(direction);
      const double step = rz / direction.dot(image);
      c += step * direction;
      r -= step * image;
      result.converged = r.norm() <= target;
      z = precondition(r);
      const double rz_next = r.dot(z);
      direction = z + rz_next / rz * direction;
      rz = rz_next;
    }
    return result;
  }
};

DenseCorrection::DenseCorrection(CrsMatrix const& Z, NodeDofView const& nonlinear)
    : implementation_(std::make_unique<Implementation>())
{
  auto& self = *implementation_;
  auto const local = Z.getLocalMatrixHost();
  self.Z.setZero(local.numRows(), local.numRows());
  for (int row = 0; row < local.numRows(); ++row) {
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      self.Z(row, local.graph.entries(k)) = local.values(k);
    }
  }
  auto const dofs = toHost(nonlinear);
  for (std::size_t node = 0; node < dofs.extent(0); ++node) {
    auto& rows = self.dofs.emplace_back();
    for (std::size_t k = 0; k < dofs.extent(1); ++k) {
      rows.push_back(dofs(node, k));
    }
  }
}

DenseCorrection::~DenseCorrection() = default;

void DenseCorrection::applyMatrix(CrsMatrix const&, Vector const& x, Vector& y) const
{
  auto const& Z = implementation_->Z;
  auto const from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const to = y.getLocalViewHost(Tpetra::Access::OverwriteAll);
  // Symmetry halves what is read.
  Eigen::Map<Eigen::VectorXd>(to.data(), Z.rows()).noalias() =
    Z.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(from.data(), Z.rows());
}

void DenseCorrection::reset() { implementation_->has_factor = false; }

CorrectionResult DenseCorrection::solve(NonlinearBlocks const& blocks, Vector const& r,
                                        double relative_tolerance, Vector& c)
{
  auto& self = *implementation_;
  self.read(blocks);
  auto const r_view = r.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const c_view = c.getLocalViewHost(Tpetra::Access::OverwriteAll);
  const Eigen::Map<const Eigen::VectorXd> given(r_view.data(), self.Z.rows());
  // A product with the mask would keep a NaN at entries of r that must not be read.
  const Eigen::VectorXd right = (self.mask.array() == 0).select(0, given);
  Eigen::Map<Eigen::VectorXd> solution(c_view.data(), self.Z.rows());

  CorrectionResult result;
  if (!self.has_factor) {
    self.factored.clear();
    self.readDiagonal();
  }
  if (self.has_factor || self.isWorthTryingDiagonal()) {
    Eigen::VectorXd iterate;
    result = self.iterate(right, relative_tolerance, iterate);
    solution = iterate;
  }
  if (!result.converged) {
    result.converged = self.factorise();
    solution = result.converged ? Eigen::VectorXd(self.precondition(right))
                                : Eigen::VectorXd(Eigen::VectorXd::Zero(right.size()));
  }
  return result;
}

std::size_t DenseCorrection::bytes() const
{
  return 2 * sizeof(double) * static_cast<std::size_t>(implementation_->Z.size());
}
} // namespace asperity::tnnmg
