#include "dynamics/fault/NormalStress.hpp"

namespace asperity::dynamics
{
NormalStress::NormalStress(ConstNodeView const& constant) : constant_(constant) {}

NormalStress::NormalStress(Function at) : at_(std::move(at)) {}

NormalStress NormalStress::following(NormalStressChange change, double floor) const
{
  auto result = *this;
  result.change_ = change;
  result.floor_ = floor;
  return result;
}

void NormalStress::at(double t, NodeView const& sigma_0) const
{
  if (at_) {
    at_(t, sigma_0);
  } else {
    Kokkos::deep_copy(sigma_0, constant_);
  }
}

void NormalStress::add(ConstNodeView const& sigma_0, ConstNodeView const& now,
                       ConstNodeView const& start, NodeView const& sigma_n) const
{
  const double floor = floor_;
  Kokkos::parallel_for(
    "asperity::dynamics::normalStress", RangePolicy(0, sigma_n.extent(0)), KOKKOS_LAMBDA(int node) {
      const double sum = sigma_0(node) + (now(node) - start(node));
      sigma_n(node) = sum < floor ? floor : sum;
    });
}

void NormalStress::raiseToFloor(NodeView const& sigma_n) const
{
  const double floor = floor_;
  Kokkos::parallel_for(
    "asperity::dynamics::normalStressFloor", RangePolicy(0, sigma_n.extent(0)),
    KOKKOS_LAMBDA(int node) { sigma_n(node) = sigma_n(node) < floor ? floor : sigma_n(node); });
}
} // namespace asperity::dynamics
