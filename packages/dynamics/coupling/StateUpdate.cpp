#include "dynamics/coupling/StateUpdate.hpp"

#include "base/program/WorkTimers.hpp"
#include "portability/Renamed.hpp"

namespace asperity::dynamics
{
namespace
{
// Half of what the change of the normal stress from `before` to `after` does to alpha.
void shiftByStress(ConstNodeView const& sensitivity, ConstNodeView const& before,
                   ConstNodeView const& after, ConstNodeView const& alpha, NodeView const& shifted)
{
  Kokkos::parallel_for(
    "asperity::dynamics::shiftByStress", RangePolicy(0, shifted.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      const double shift =
        sensitivity(node) == 0
          ? 0
          : sensitivity(node) / 2 * (math::log(after(node)) - math::log(before(node)));
      shifted(node) = alpha(node) - shift;
    });
}
} // namespace

StateUpdate::StateUpdate(Fault const& fault) : fault_(fault)
{
  if (fault.laws().stress_sensitivity.extent(0) > 0) {
    shifted_ = NodeView("asperity::dynamics::shifted", fault.surface().numNodes());
  }
}

int StateUpdate::respond(FaultResponse const& to, NodeView const& image)
{
  ASPERITY_TIME_WORK("state updates");
  auto const& sensitivity = fault_.laws().stress_sensitivity;
  if (shifted_.extent(0) == 0) {
    return fault_.state().flow(to.slip_rate, to.tau, to.from.alpha, image);
  }
  auto const before = fault_.given(to.from).sigma_n, after = fault_.given(to.to).sigma_n;
  shiftByStress(sensitivity, before, after, to.from.alpha, shifted_);
  const int failures = fault_.state().flow(to.slip_rate, to.tau, shifted_, image);
  shiftByStress(sensitivity, before, after, image, image);
  return failures;
}
} // namespace asperity::dynamics
