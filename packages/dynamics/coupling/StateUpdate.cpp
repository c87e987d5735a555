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

// sum := sum + weight values
void add(double weight, ConstNodeView const& values, NodeView const& sum)
{
  Kokkos::parallel_for(
    "asperity::dynamics::addToAlpha", RangePolicy(0, sum.extent_int(0)),
    KOKKOS_LAMBDA(int node) { sum(node) += weight * values(node); });
}
} // namespace

StateUpdate::StateUpdate(Fault const& fault)
    : fault_(fault)
    , before_(fault.processes(), fault.surface().numNodes())
    , after_(fault.processes(), fault.surface().numNodes())
    , carried_("asperity::dynamics::carriedAlpha", fault.surface().numNodes())
{
  if (fault.laws().stress_sensitivity.extent(0) > 0) {
    shifted_ = NodeView("asperity::dynamics::shifted", fault.surface().numNodes());
  }
}

void StateUpdate::begin(StepStart const& start)
{
  Kokkos::deep_copy(carried_, start.from.alpha_defect);
  add(1, carried_, start.to.alpha);
}

int StateUpdate::respond(StepIterate const& step, NodeView const& image)
{
  ASPERITY_TIME_WORK("state updates");
  const int failures = flow(step, image);
  add(1, carried_, image);
  return failures;
}

void StateUpdate::finish(ConstNodeView const& image, State const& to) const
{
  Kokkos::deep_copy(to.alpha_defect, image);
  add(-1, to.alpha, to.alpha_defect);
  Kokkos::deep_copy(to.alpha, image);
  add(-1, carried_, to.alpha);
}

int StateUpdate::flow(StepIterate const& step, NodeView const& image)
{
  auto const& sensitivity = fault_.laws().stress_sensitivity;
  if (shifted_.extent(0) == 0) {
    return fault_.state().flow(step.slip_rate, step.tau, step.from.alpha, image);
  }
  auto const before = before_.at(step.from).sigma_n, after = after_.at(step.to).sigma_n;
  shiftByStress(sensitivity, before, after, step.from.alpha, shifted_);
  const int failures = fault_.state().flow(step.slip_rate, step.tau, shifted_, image);
  shiftByStress(sensitivity, before, after, image, image);
  return failures;
}
} // namespace asperity::dynamics
