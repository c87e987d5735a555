#include "tnnmg/direct/DenseCorrection.hpp"

#include "tnnmg/direct/KeptFactor.hpp"

#include <Tpetra_Vector.hpp>

#include <optional>

namespace asperity::tnnmg
{
namespace
{
// Tolerances of at least this value allow single precision, which is faster.
constexpr double loosest_for_double = 1e-4;

std::vector<std::vector<int>> rowsOf(NodeDofView const& nonlinear)
{
  auto const dofs = toHost(nonlinear);
  std::vector<std::vector<int>> rows(dofs.extent(0));
  for (std::size_t node = 0; node < dofs.extent(0); ++node) {
    for (std::size_t k = 0; k < dofs.extent(1); ++k) {
      rows[node].push_back(dofs(node, k));
    }
  }
  return rows;
}
} // namespace

struct DenseCorrection::Implementation
{
  Implementation(ConstBlockView const& given, NodeDofView const& nonlinear)
      : on_host(toHost(given))
      , Z(on_host.data(), on_host.extent_int(0), on_host.extent_int(1))
      , dofs(rowsOf(nonlinear))
  {
  }

  decltype(toHost(ConstBlockView())) on_host;
  Eigen::Map<const Eigen::MatrixXd> Z;
  std::vector<std::vector<int>> dofs; // of each node
  std::optional<detail::KeptFactor<float>> single;
  std::optional<detail::KeptFactor<double>> exact; // once it is needed
};

DenseCorrection::DenseCorrection(ConstBlockView const& Z, NodeDofView const& nonlinear)
    : implementation_(std::make_unique<Implementation>(Z, nonlinear))
{
}

DenseCorrection::~DenseCorrection() = default;

void DenseCorrection::reset()
{
  auto& self = *implementation_;
  if (self.single) {
    self.single->forgetFactor();
  }
  if (self.exact) {
    self.exact->forgetFactor();
  }
}

CorrectionResult DenseCorrection::solve(NonlinearBlocks const& blocks, Vector const& r,
                                        double relative_tolerance, Vector& c)
{
  auto& self = *implementation_;
  auto const r_view = r.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const c_view = c.getLocalViewHost(Tpetra::Access::OverwriteAll);
  const Eigen::VectorXd right = Eigen::Map<const Eigen::VectorXd>(r_view.data(), self.Z.rows());
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(self.Z.rows());
  const auto solveIn = [&](auto& system) {
    if (!system) {
      system.emplace(self.Z, self.dofs);
    }
    return system->solve(blocks, right, relative_tolerance, solution);
  };
  CorrectionResult result;
  if (relative_tolerance >= loosest_for_double) {
    result = solveIn(self.single);
  }
  if (!result.converged) { // no factor, or too ill-conditioned for single precision
    const int iterations = result.iterations;
    result = solveIn(self.exact);
    result.iterations += iterations;
  }
  Eigen::Map<Eigen::VectorXd>(c_view.data(), self.Z.rows()) = solution;
  return result;
}

std::size_t DenseCorrection::bytes() const
{
  auto const& self = *implementation_;
  const auto entries = static_cast<std::size_t>(self.Z.size());
  return entries * ((self.single ? 2 * sizeof(float) : 0) + (self.exact ? 2 * sizeof(double) : 0));
}
} // namespace asperity::tnnmg
