#include "dynamics/watches/SlowSlip.hpp"

#include "base/parallel/Reductions.hpp"

#include <algorithm>

namespace asperity::dynamics
{
SlowSlip::SlowSlip(std::vector<double> const& L, double rate)
    : L_(toDevice(L, "asperity::dynamics::weakeningDistance"))
    , rate_(rate)
{
}

double SlowSlip::largestRatio(ConstNodeView const& V, double step_size,
                              Communicator const& communicator) const
{
  const auto L = L_;
  const double slow = rate_;
  double largest = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::slowSlip", RangePolicy(0, L.extent_int(0)),
    KOKKOS_LAMBDA(int node, double& most) {
      const double slip = L(node) > 0 && V(node) < slow ? V(node) * step_size / L(node) : 0;
      most = slip > most ? slip : most;
    },
    Kokkos::Max<double>(largest));
  return maxOverRanks(std::max(largest, 0.), communicator); // a rank may have no node
}
} // namespace asperity::dynamics
