#include "scenario/watches/PressureWatch.hpp"

#include "base/Text.hpp"
#include "base/parallel/FirstRank.hpp"

#include <optional>

namespace asperity::scenario
{
void PressureWatch::note(dynamics::WatchedState const& now, dynamics::Notes& notes)
{
  if (has_warned_ || fault_.laws().processes.empty() || fault_.surface().mayOpen()) {
    return;
  }
  auto const& surface = fault_.surface();
  const ConstNodeView sigma_n = now.state.sigma_n, left = fault_.effectiveStress(now.state);
  auto const slides = surface.slidingNodes();
  int node = surface.numNodes(); // the first one, if there is one
  Kokkos::parallel_reduce(
    "asperity::scenario::firstWithoutStress", RangePolicy(0, surface.numNodes()),
    KOKKOS_LAMBDA(int i, int& first) {
      first = slides(i) && sigma_n(i) > 0 && left(i) <= 0 && i < first ? i : first;
    },
    Kokkos::Min<int>(node));
  const bool is_here = node < surface.numNodes();
  auto const place = ofFirstRank<3>(is_here ? std::optional(surface[node].place) : std::nullopt,
                                    *surface.communicator());
  if (!place) {
    return;
  }
  has_warned_ = true;
  notes.add(Warning{"effective normal stress",
                    "At t = " + formatShort(now.time) +
                      " s a pressure on the fault has reached the normal stress, first at " +
                      formatPoint({place->begin(), place->end()}) +
                      ": friction is zero there, and the model does not let faults open. Check the "
                      "initial pressure, the normal stress and the parameters of the fluid."});
}
} // namespace asperity::scenario

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "pressure_watch",
                  asperity::dynamics::WatchKindOf<asperity::scenario::PressureWatch>)
