#include "scenario/run/PressureWatch.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"

#include <array>
#include <limits>

namespace asperity::scenario
{
std::optional<Warning> PressureWatch::note(dynamics::FaultSample const& now, double time)
{
  if (has_warned_ || fault_.laws().processes.empty()) {
    return std::nullopt;
  }
  auto const& surface = fault_.surface();
  auto const &sigma_n = now.normalStress(), &left = now.effectiveStress();
  int node = 0;
  while (node < surface.numNodes() &&
         !(surface.slides(node) && sigma_n[node] > 0 && left[node] <= 0)) {
    ++node;
  }
  const bool is_here = node < surface.numNodes();
  auto const& communicator = *surface.communicator();
  const int rank = communicator.getRank(), none = communicator.getSize();
  const int lowest = minOverRanks(is_here ? rank : none, communicator);
  if (lowest == none) {
    return std::nullopt;
  }
  has_warned_ = true;
  std::array<double, 3> place;
  place.fill(std::numeric_limits<double>::lowest());
  place = maxOverRanks(lowest == rank ? surface[node].place : place, communicator);
  return Warning{"effective normal stress",
                 "At t = " + formatShort(time) +
                   " s a pressure on the fault has reached the normal stress, first at " +
                   formatPoint({place[0], place[1], place[2]}) +
                   ": friction is zero there, and the model does not let faults open. Check the "
                   "initial pressure, the normal stress and the parameters of the fluid."};
}
} // namespace asperity::scenario
