#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"

#include <vector>

namespace asperity::dynamics
{
// How far a step slips where friction weakens, as a multiple of L. Steady slip is unstable there,
// and grows by a factor e within a slip of about L a / (b - a). An implicit step that slips several
// L damps that growth, and its error estimate sees nothing of it. Seismic slip, which inertia or
// radiation limits, is steady without such damping, and does not count.
class SlowSlip
{
public:
  // L: (num_nodes), the slip distance [m] where friction weakens, 0 elsewhere; empty if there is
  // nothing to watch. rate: the largest slip rate [m/s] that counts as slow.
  SlowSlip(std::vector<double> const& L, double rate);

  // The largest V dt / L [-] over the weakening nodes of all ranks whose V(num_nodes) [m/s] is
  // slow. Collective.
  double largestRatio(ConstNodeView const& V, double step_size,
                      Communicator const& communicator) const;

private:
  NodeView L_;
  double rate_;
};
} // namespace asperity::dynamics
