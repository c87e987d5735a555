#include "dynamics/coupling/AndersonAcceleration.hpp"

#include "base/parallel/Reductions.hpp"

#include <Eigen/Dense>

namespace asperity::dynamics
{
namespace
{
// Pivots of the normal equations below this share of the largest one count as zero. Lengths enter
// squared, so that differences of residuals count as dependent at an angle of 1e-5.
constexpr double rank_threshold = 1e-10;

NodeView copyOf(ConstNodeView const& values)
{
  const NodeView copy("asperity::dynamics::iterate", values.extent(0));
  Kokkos::deep_copy(copy, values);
  return copy;
}

// This rank's part of the weighted sum of (a - b) (a - c).
double product(ConstNodeView const& weight, ConstNodeView const& a, ConstNodeView const& b,
               ConstNodeView const& c)
{
  double sum = 0;
  const int size = static_cast<int>(weight.extent(0));
  Kokkos::parallel_reduce(
    "asperity::dynamics::productOfResiduals", RangePolicy(0, a.extent(0)),
    KOKKOS_LAMBDA(int i, double& partial) {
      partial += weight(i % size) * (a(i) - b(i)) * (a(i) - c(i));
    },
    sum);
  return sum;
}
} // namespace

AndersonAcceleration::AndersonAcceleration(ConstNodeView const& weights,
                                           RCP<const Communicator> const& communicator, int depth)
    : weights_(weights)
    , communicator_(communicator)
    , depth_(static_cast<std::size_t>(depth))
{
}

// The least squares problem
//   min over gamma of | f0 - sum_j gamma_j (f0 - fj) |
// by its normal equations; column 0 of `products` is their right side, since f0 = f0 - 0.
std::vector<double> AndersonAcceleration::coefficients() const
{
  const int size = static_cast<int>(iterates_.size()) - 1;
  auto const last = iterates_.front().residual;
  const NodeView zero("asperity::dynamics::zero", last.extent(0));
  Eigen::MatrixXd mine(size, size + 1);
  for (int j = 0; j < size; ++j) {
    auto const residual = iterates_[j + 1].residual;
    mine(j, 0) = product(weights_, last, residual, zero);
    for (int l = 0; l < size; ++l) {
      mine(j, l + 1) = product(weights_, last, residual, iterates_[l + 1].residual);
    }
  }
  const Eigen::MatrixXd products = sumOverRanks(mine, *communicator_);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> normal;
  normal.setThreshold(rank_threshold);
  normal.compute(products.rightCols(size));
  const Eigen::VectorXd gamma = normal.solve(products.col(0));
  return {gamma.data(), gamma.data() + size};
}

void AndersonAcceleration::advance(NodeView const& x, ConstNodeView const& image)
{
  if (depth_ == 0) {
    Kokkos::deep_copy(x, image);
    return;
  }
  Iterate iterate = {copyOf(image), copyOf(image)};
  auto const residual = iterate.residual;
  Kokkos::parallel_for(
    "asperity::dynamics::residual", RangePolicy(0, x.extent(0)), KOKKOS_LAMBDA(int node) {
      residual(node) -= x(node);
      x(node) = image(node);
    });
  iterates_.push_front(iterate);
  if (iterates_.size() > depth_ + 1) {
    iterates_.pop_back();
  }
  if (iterates_.size() == 1) {
    return;
  }
  auto const gamma = coefficients();
  for (std::size_t j = 0; j < gamma.size(); ++j) {
    auto const earlier = iterates_[j + 1].image;
    const double coefficient = gamma[j];
    Kokkos::parallel_for(
      "asperity::dynamics::takeOut", RangePolicy(0, x.extent(0)),
      KOKKOS_LAMBDA(int node) { x(node) -= coefficient * (image(node) - earlier(node)); });
  }
}
} // namespace asperity::dynamics
