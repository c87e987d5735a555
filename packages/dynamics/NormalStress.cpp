#include "dynamics/NormalStress.hpp"

namespace asperity::dynamics
{
NormalStress::NormalStress(friction::ConstNodeView const& constant) : constant_(constant) {}

NormalStress::NormalStress(Function at) : at_(std::move(at)) {}

void NormalStress::at(double t, friction::NodeView const& sigma_n) const
{
  if (at_) {
    at_(t, sigma_n);
  } else {
    Kokkos::deep_copy(sigma_n, constant_);
  }
}
} // namespace asperity::dynamics
